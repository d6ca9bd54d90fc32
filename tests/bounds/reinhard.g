# reinhard (raster/film.hpp), below 1: r / (1 + r) in float, relative.
@rnd = float<ieee_32, ne>;
r = rnd(r_);
F rnd= r / (1 + r);
E = r / (1 + r);
{ r in [1b-60, 1] -> |F -/ E| <= 1.1921e-7 }
