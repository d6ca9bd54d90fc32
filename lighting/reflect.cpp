#include "lighting/reflect.hpp"

#include <glm/geometric.hpp>

#include "lighting/ward.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

ReflectedTerms reflect_along_grain(const PointMaterial& material, const glm::vec3& n, const glm::vec3& l,
                                   const glm::vec3& v) {
    const PhongMaterial& m = material.phong;
    const glm::vec3 t = tangent_of_grain(glm::normalize(m.grain), n);
    if (material.model == ReflectionModel::heidrich_seidel) return heidrich_seidel(n, t, l, v, m);
    return ward_brushed(n, t, l, v, m, *m.ward_alpha);
}

}  // namespace

ReflectedTerms reflect(const PointMaterial& material, const glm::vec3& n, const glm::vec3& l, const glm::vec3& v) {
    const PhongMaterial& m = material.phong;
    switch (material.model) {
        case ReflectionModel::unlit: return {};
        case ReflectionModel::lambert: return lambert(n, l, m);
        case ReflectionModel::phong: return phong(n, l, v, m);
        case ReflectionModel::blinn_phong: return blinn_phong(n, l, v, m);
        case ReflectionModel::ward: return m.ward_alpha ? reflect_along_grain(material, n, l, v) : ward(n, l, v, m);
        case ReflectionModel::heidrich_seidel: return reflect_along_grain(material, n, l, v);
        case ReflectionModel::cook_torrance:
            KREDA_EXPECT(material.setup);
            return cook_torrance(n, l, v, *material.setup, material.surface);
    }
    return {};
}

}  // namespace kreda::lighting
