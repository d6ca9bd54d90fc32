// The functions that passes run. The plan names them, scene/render defines them: what each reads and writes stands
// there.
#pragma once

namespace kreda::scene {

struct PassWork;

// Once: scene/render/bake_passes.cpp
void bake_cube(const PassWork& work);
void bake_levels(const PassWork& work);
void bake_irradiance(const PassWork& work);
void bake_brdf(const PassWork& work);

// A frame: scene/render/frame_passes.cpp, early_lighting.cpp, shadow_pass.cpp, frame_shadows.cpp, sides.cpp
void place_vertices(const PassWork& work);
void build_shadow(const PassWork& work);
void light_vertices(const PassWork& work);
void fog_vertices(const PassWork& work);
void place_triangles(const PassWork& work);
void judge_sides(const PassWork& work);
void collect_visible_samples(const PassWork& work);
void make_frame_shadow(const PassWork& work);
void light_triangles(const PassWork& work);

// A tile: scene/render/tile_pass.cpp
void find_nearest(const PassWork& work);
void start_background(const PassWork& work);
void show_depth(const PassWork& work);
void choose_shading_points(const PassWork& work);
void spread_points(const PassWork& work);
void paint_flat(const PassWork& work);
void write_film(const PassWork& work);
void write_bytes(const PassWork& work);

// A batch: scene/render/batch_passes.cpp
void interpolate(const PassWork& work);
void light_samples(const PassWork& work);
void color_flat(const PassWork& work);
void fog_samples(const PassWork& work);
void mix_fog(const PassWork& work);
void paint(const PassWork& work);
void show_view(const PassWork& work);

// A batch of points that are lit: scene/render/shade.cpp
void look_up_maps(const PassWork& work);
void set_surface(const PassWork& work);
void add_environment(const PassWork& work);
void add_light(const PassWork& work);

}  // namespace kreda::scene
