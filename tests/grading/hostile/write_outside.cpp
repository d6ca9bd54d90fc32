#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cstdio>
#include <initializer_list>
float attack() {
    for (const char* path : {OUTSIDE "/mine", "/tmp/kreda_hostile", "/var/tmp/kreda_hostile", "/dev/shm/kreda_hostile",
                             "/kreda_hostile", "/usr/kreda_hostile", "/etc/kreda_hostile", "../kreda_hostile"}) {
        const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
        if (file >= 0 && write(file, "leak", 4) == 4) write(1, "leak: wrote\n", 12);
    }
    truncate(SECRET, 0);
    unlink(SECRET);
    rename(SECRET, SECRET ".gone");
    chmod(SECRET, 0777);
    chown(SECRET, getuid(), getgid());
    rmdir(OUTSIDE);
    mkdir(OUTSIDE "/folder", 0755);
    symlink(SECRET, OUTSIDE "/link");
    return 0.0f;
}
