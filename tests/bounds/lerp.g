# lerp (raster/scalar_math.hpp): (1 - t) a + t b in float, a, b and t in [0, 1].
@rnd = float<ieee_32, ne>;
a = rnd(a_);
b = rnd(b_);
t = rnd(t_);
F rnd= (1 - t) * a + t * b;
E = (1 - t) * a + t * b;
{ a in [0, 1] /\ b in [0, 1] /\ t in [0, 1] -> |F - E| <= 1.4902e-7 }
