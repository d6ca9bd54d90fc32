#include "scene/plan/wanted.hpp"

#include "scene/plan/views.hpp"

namespace kreda::scene {

namespace {

void add(const Wanted& more, Wanted& wanted) {
    wanted.radiance |= more.radiance;
    wanted.maps |= more.maps;
    wanted.surface |= more.surface;
    wanted.position |= more.position;
    wanted.environment |= more.environment;
    wanted.lamps |= more.lamps;
    wanted.last_lamp |= more.last_lamp;
    wanted.last_shadow |= more.last_shadow;
    wanted.fog |= more.fog;
    wanted.shadows |= more.shadows;
}

}  // namespace

Wanted wanted_of(const PlanRequest& request) {
    if (!request.film && request.views.size() == 1) {
        const Wanted& wanted = request.views[0]->wanted;
        if (!wanted.radiance) return wanted;
    }
    Wanted wanted{.radiance = true, .maps = true, .surface = true, .position = true, .effects = true, .shadows = true};
    wanted.environment = wanted.lamps = wanted.fog = true;
    for (const View* view : request.views) add(view->wanted, wanted);
    return wanted;
}

}  // namespace kreda::scene
