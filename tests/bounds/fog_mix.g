# mix_fog (lighting/fog.hpp): f s + (1 - f) c in float, f in [0, 1], radiances up to 16.
@rnd = float<ieee_32, ne>;
f = rnd(f_);
s = rnd(s_);
c = rnd(c_);
F rnd= f * s + (1 - f) * c;
E = f * s + (1 - f) * c;
{ f in [0, 1] /\ s in [0, 16] /\ c in [0, 16] -> |F - E| <= 2.3842e-6 }
