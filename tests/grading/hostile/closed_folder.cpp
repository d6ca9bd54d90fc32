// A folder that the grader cannot look into.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
float attack() {
    mkdir("closed", 0755);
    close(open("closed/file", O_WRONLY | O_CREAT, 0644));
    const int folder = open("closed", O_RDONLY | O_DIRECTORY);
    fchmod(folder, 0);
    return 0.0f;
}
