// Which map a file's name announces: the habits of the large texture libraries and tools.
#include <string>

#include <doctest/doctest.h>

#include "scene/files/map_folder.hpp"

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

TEST_CASE("maps: names of the large libraries and tools are understood") {
    struct Name {
        const char* file;
        const char* map;
    };
    for (const Name& name : {Name{"wood_diff_2k.jpg", "albedo"},  // Poly Haven
                             Name{"wood_nor_gl_2k.exr", "normal"},
                             Name{"wood_nor_dx_2k.exr", "normal_down"},
                             Name{"wood_rough_2k.jpg", "roughness"},
                             Name{"wood_ao_2k.jpg", "ao"},
                             Name{"wood_arm_2k.jpg", ""},                  // three maps in one
                             Name{"Metal007_2K-PNG_Color.png", "albedo"},  // ambientCG
                             Name{"Metal007_2K-PNG_NormalGL.png", "normal"},
                             Name{"Metal007_2K-PNG_NormalDX.png", "normal_down"},
                             Name{"Metal007_2K-PNG_Metalness.png", "metallic"},
                             Name{"Metal007_2K-PNG_AmbientOcclusion.png", "ao"},
                             Name{"Metal007_2K-PNG.png", ""},
                             Name{"Rust01_COL_2K_METALNESS.png", "albedo"},  // Poliigon
                             Name{"Rust01_COL_VAR1_2K_METALNESS.png", "albedo"},
                             Name{"Rust01_ROUGHNESS_2K_METALNESS.png", "roughness"},
                             Name{"Rust01_NRM_2K_METALNESS.png", "normal"},
                             Name{"Rust01_METALNESS_2K_METALNESS.png", "metallic"},
                             Name{"Rust01_AO_2K_METALNESS.png", "ao"},
                             Name{"Rust01_DISP_2K_METALNESS.png", ""},
                             Name{"Rust01_COL_2K_SPECULAR.png", "albedo"},
                             Name{"Rust01_COL_2K.jpg", "albedo"},
                             Name{"rustediron2_basecolor.png", "albedo"},  // FreePBR
                             Name{"rock_albedo.png", "albedo"},
                             Name{"rock_normal-ogl.png", "normal"},
                             Name{"rock_normal-dx.png", "normal_down"},
                             Name{"Barrel_Base_Color.png", "albedo"},  // Substance
                             Name{"Barrel_BaseColor.1001.png", "albedo"},
                             Name{"Barrel_Roughness.png", "roughness"},
                             Name{"Barrel_Normal_OpenGL.png", "normal"},
                             Name{"Barrel_Mixed_AO.png", "ao"},
                             Name{"tgbl_2K_Albedo.jpg", "albedo"},  // Quixel
                             Name{"tgbl_2K_Normal_LOD0.jpg", "normal"},
                             Name{"tgbl_2K_Metalness.jpg", "metallic"},
                             Name{"Metal_Plate_041_basecolor.jpg", "albedo"},  // 3DTextures
                             Name{"Metal_Plate_041_ambientOcclusion.jpg", "ao"},
                             Name{"Metal_Plate_041_NORM.jpg", "normal"},
                             Name{"Metal_Plate_041_height.png", ""},
                             Name{"TexturesCom_Brick_1K_albedo.tif", "albedo"},  // textures.com
                             Name{"Bricks_2K_BaseColor.png", "albedo"},          // cgbookcase
                             Name{"metal_0001_normal_opengl_1k.png", "normal"},  // TextureCan
                             Name{"helmet_baseColor.png", "albedo"},             // glTF
                             Name{"helmet_metallicRoughness.png", ""},
                             Name{"Default_AO.jpg", "ao"},
                             Name{"T_Rock_D.tga", "albedo"},  // Unreal
                             Name{"T_Rock_BC.tga", "albedo"},
                             Name{"T_Rock_N.tga", "normal_down"},
                             Name{"T_Rock_R.tga", "roughness"},
                             Name{"T_Rock_M.tga", "metallic"},
                             Name{"T_Rock_ORM.tga", ""},
                             Name{"vitamin_d.png", ""}}) {
        CAPTURE(name.file);
        CHECK(map_announced_by(name.file) == name.map);
    }
}
