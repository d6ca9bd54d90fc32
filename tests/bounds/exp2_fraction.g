# exp2_of_fraction (raster/scalar_math.hpp): what rounding adds to the polynomial, f in [-1/2, 1/2]. The coefficients are
# floats; how far the polynomial is from 2^f, 2.2e-9, is another error.
@rnd = float<ieee_32, ne>;
f = rnd(f_);
a6 = rnd(0.00015342074);
a5 = rnd(0.00133968994);
a4 = rnd(0.00961847045);
a3 = rnd(0.0555033945);
a2 = rnd(0.240226477);
a1 = rnd(0.193147197);
p rnd= ((((a6 * f + a5) * f + a4) * f + a3) * f + a2) * f + a1;
F rnd= 1 + (0.5 * f + f * p);
P = ((((a6 * f + a5) * f + a4) * f + a3) * f + a2) * f + a1;
E = 1 + (0.5 * f + f * P);
{ f in [-0.5, 0.5] -> |F - E| <= 1.0484e-7 }
