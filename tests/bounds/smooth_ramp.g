# smooth_ramp (raster/scalar_math.hpp): t t (3 - 2 t) in float, t in [0, 1].
@rnd = float<ieee_32, ne>;
t = rnd(t_);
F rnd= t * t * (3 - 2 * t);
E = t * t * (3 - 2 * t);
{ t in [0, 1] -> |F - E| <= 3.2783e-7 }
