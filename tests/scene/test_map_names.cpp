// Which map a file's name announces: the habits of the large texture libraries and tools.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/map_names.hpp"

using namespace kreda::scene;

TEST_CASE("maps: names of real sets are understood") {
    for (const char* name :
         {"albedo.png", "Metal007_1K_Color.jpg", "rust_BaseColor.tga", "wall_diff_2k.jpg", "T_Rock_Base_Color.png"}) {
        CAPTURE(name);
        CHECK(map_announced_by(name) == "albedo");
    }
    CHECK(map_announced_by("Metal007_1K_Metalness.jpg") == "metallic");
    CHECK(map_announced_by("iron-Metallic.PNG") == "metallic");
    CHECK(map_announced_by("wall_rough_4k.exr") == "roughness");
    CHECK(map_announced_by("AmbientOcclusion.png") == "ao");
    CHECK(map_announced_by("rock_ambient_occlusion.png") == "ao");
    CHECK(map_announced_by("Metal007_1K_NormalGL.jpg") == "normal");
    CHECK(map_announced_by("rock_nor_gl_1k.png") == "normal");
    CHECK(map_announced_by("Metal007_1K_NormalDX.jpg") == "normal_down");
    for (const char* name :
         {"Metal007_1K_Displacement.jpg", "preview.png", "cacao.png", "1024.png", "normal_map_of_me.png"}) {
        CAPTURE(name);
        CHECK(map_announced_by(name).empty());
    }
}

namespace {

struct Name {
    std::string file;
    std::string map;
};

}  // namespace

TEST_CASE("maps: names of the large libraries are understood") {
    for (const Name& name : {
             // Poly Haven
             Name{"wood_diff_2k.jpg", "albedo"},
             Name{"wood_nor_gl_2k.exr", "normal"},
             Name{"wood_nor_dx_2k.exr", "normal_down"},
             Name{"wood_rough_2k.jpg", "roughness"},
             Name{"wood_ao_2k.jpg", "ao"},
             Name{"wood_arm_2k.jpg", ""},
             Name{"wood_disp_4k.png", ""},
             Name{"rusty_metal_02_metal_1k.exr", "metallic"},
             Name{"rusty_metal_rough_1k.exr", "roughness"},
             Name{"fabric_pattern_07_col_1_4k.png", "albedo"},
             Name{"wood_floor_spec_2k.jpg", ""},
             Name{"rough_plaster_broken_diff_1k.jpg", "albedo"},
             // ambientCG, also as it was when it was called cc0textures
             Name{"Metal007_2K-PNG_Color.png", "albedo"},
             Name{"Metal007_2K-PNG_NormalGL.png", "normal"},
             Name{"Metal007_2K-PNG_NormalDX.png", "normal_down"},
             Name{"Metal007_2K-PNG_Metalness.png", "metallic"},
             Name{"Metal007_2K-PNG_AmbientOcclusion.png", "ao"},
             Name{"Metal007_2K-PNG.png", ""},
             Name{"Metal007.png", ""},
             Name{"Lava004_4K-JPG_Emission.jpg", "emission"},
             Name{"Leaf001_2K-JPG_Opacity.jpg", ""},
             Name{"Metal007_1K-JPG_Displacement.jpg", ""},
             Name{"Bricks01_col.jpg", "albedo"},
             Name{"Bricks01_nrm.jpg", "normal"},
             Name{"Bricks01_rgh.jpg", "roughness"},
             Name{"Bricks01_met.jpg", "metallic"},
             Name{"Bricks01_disp.jpg", ""},
             // Poliigon, old and new
             Name{"Rust01_COL_2K_METALNESS.png", "albedo"},
             Name{"Rust01_COL_VAR1_2K_METALNESS.png", "albedo"},
             Name{"Rust01_ROUGHNESS_2K_METALNESS.png", "roughness"},
             Name{"Rust01_NRM_2K_METALNESS.png", "normal"},
             Name{"Rust01_METALNESS_2K_METALNESS.png", "metallic"},
             Name{"Rust01_AO_2K_METALNESS.png", "ao"},
             Name{"Rust01_DISP_2K_METALNESS.png", ""},
             Name{"Rust01_COL_2K_SPECULAR.png", "albedo"},
             Name{"Rust01_COL_2K.jpg", "albedo"},
             Name{"Rust01_NRM16_3K.tif", "normal"},
             Name{"Rust01_GLOSS_3K.jpg", ""},
             Name{"Poliigon_BrickWall_8320_BaseColor.jpg", "albedo"},
             Name{"Poliigon_BrickWall_8320_AmbientOcclusion.jpg", "ao"},
             Name{"Poliigon_BrickWall_8320_ORM.jpg", ""},
             Name{"Poliigon_BrickWall_8320_Preview1.png", ""},
             // FreePBR, with and without separators
             Name{"rustediron2_basecolor.png", "albedo"},
             Name{"rock_albedo.png", "albedo"},
             Name{"copper-rock1-alb.png", "albedo"},
             Name{"rock_normal-ogl.png", "normal"},
             Name{"rock_normal-dx.png", "normal_down"},
             Name{"worn-shiny-metal-Metallic.png", "metallic"},
             Name{"granitesmooth1-roughness3.png", "roughness"},
             Name{"octostoneAlbedo.png", "albedo"},
             Name{"octostoneRoughness2.png", "roughness"},
             Name{"octostoneAO.png", "ao"},
             Name{"octostoneNormalGL.png", "normal"},
             Name{"rock1-height.png", ""},
             // Quixel Megascans, three generations
             Name{"tgbl_2K_Albedo.jpg", "albedo"},
             Name{"tgbl_2K_Normal_LOD0.jpg", "normal"},
             Name{"tgbl_2K_Metalness.jpg", "metallic"},
             Name{"tgbl_2K_Cavity.jpg", ""},
             Name{"tgbl_2K_Bump.jpg", ""},
             Name{"tgbl_4K_Gloss.jpg", ""},
             Name{"Albedo_4K__vdcjcbs.jpg", "albedo"},
             Name{"Normal_4K__vdcjcbs.jpg", "normal"},
             Name{"Specular_4K__vdcjcbs.jpg", ""},
             Name{"T_vgsmdfb_2K_B.png", "albedo"},
             Name{"T_vgsmdfb_2K_N.png", "normal_down"},
             Name{"T_vgsmdfb_2K_ORDp.png", ""},
             // 3dtextures, textures.com, cgbookcase, TextureCan, ShareTextures
             Name{"Metal_Plate_041_basecolor.jpg", "albedo"},
             Name{"Metal_Plate_041_ambientOcclusion.jpg", "ao"},
             Name{"Metal_Plate_041_NORM.jpg", "normal"},
             Name{"Metal_Plate_041_OCC.jpg", "ao"},
             Name{"Metal_Plate_041_height.png", ""},
             Name{"TexturesCom_Brick_1K_albedo.tif", "albedo"},
             Name{"TexturesCom_Concrete_Rough_1K_normal.tif", "normal"},
             Name{"TexturesCom_Brick_1_seamless_S.jpg", ""},
             Name{"Bricks_2K_BaseColor.png", "albedo"},
             Name{"Bricks01_MR_2K_Metallic.png", "metallic"},
             Name{"metal_0001_normal_opengl_1k.png", "normal"},
             Name{"metal_0001_normal_directx_1k.png", "normal_down"},
             Name{"metal_0001_color_1k.jpg", "albedo"},
             Name{"wood_25_Basecolor-1K.jpg", "albedo"},
             Name{"wood_25_ambientocclusion-1K.jpg", "ao"},
         }) {
        CAPTURE(name.file);
        CHECK(map_announced_by(name.file) == name.map);
    }
}

TEST_CASE("maps: names that programs write are understood") {
    for (const Name& name : {
             // Substance, with tiles and variants
             Name{"Barrel_Base_Color.png", "albedo"},
             Name{"Barrel_BaseColor.1001.png", "albedo"},
             Name{"Barrel_BaseColor_u1_v2.png", "albedo"},
             Name{"Barrel_Roughness.png", "roughness"},
             Name{"Barrel_Normal_OpenGL.png", "normal"},
             Name{"Barrel_Normal_DirectX.png", "normal_down"},
             Name{"Barrel_Mixed_AO.png", "ao"},
             Name{"Barrel_Emissive.png", "emission"},
             Name{"Barrel_OcclusionRoughnessMetallic.png", ""},
             Name{"Barrel_basecolor_v2.png", "albedo"},
             // glTF
             Name{"helmet_baseColor.png", "albedo"},
             Name{"helmet_metallicRoughness.png", ""},
             Name{"Default_metalRoughness.jpg", ""},
             Name{"BoomBox_occlusionRoughnessMetallic.png", ""},
             Name{"Default_AO.jpg", "ao"},
             Name{"Default_emissive.jpg", "emission"},
             // Unity
             Name{"Crate_AlbedoTransparency.png", "albedo"},
             Name{"Crate_MetallicSmoothness.png", ""},
             Name{"Crate_Occlusion.png", "ao"},
             Name{"Crate_MainTex.png", "albedo"},
             // Unreal
             Name{"T_Rock_D.tga", "albedo"},
             Name{"T_Rock_BC.tga", "albedo"},
             Name{"T_Rock_N.tga", "normal_down"},
             Name{"T_Rock_R.tga", "roughness"},
             Name{"T_Rock_M.tga", "metallic"},
             Name{"T_Rock_E.tga", "emission"},
             Name{"T_Rock_ORM.tga", ""},
             Name{"vitamin_d.png", ""},
             // what people and Blender's bakes call them
             Name{"normalMap.png", "normal"},
             Name{"wood_roughness_map.png", "roughness"},
             Name{"wood_bump_map.png", ""},
             Name{"wood_diffuse_seamless.jpg", "albedo"},
             Name{"wood diffuse (1).png", "albedo"},
             Name{"world_map.png", ""},
             Name{"lightmap.png", ""},
         }) {
        CAPTURE(name.file);
        CHECK(map_announced_by(name.file) == name.map);
    }
}
