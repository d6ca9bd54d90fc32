# ggx_distribution (lighting/microfacet.hpp), relative: D = (alpha / q)^2 / pi, q = sin^2 + (n.h)^2 alpha^2, in float.
# Two positive terms cannot cancel: the bound holds for every alpha down to 0.001.
@rnd = float<ieee_32, ne>;
c = rnd(c_);
s = rnd(s_);
alpha = rnd(alpha_);
inv_pi = rnd(0.31830988618);
c_alpha rnd= c * alpha;
q rnd= s + c_alpha * c_alpha;
alpha_by_q rnd= alpha / q;
F rnd= alpha_by_q * alpha_by_q * inv_pi;
C_alpha = c * alpha;
Q = s + C_alpha * C_alpha;
E = (alpha / Q) * (alpha / Q) * inv_pi;
{ c in [0.001, 1] /\ s in [1b-40, 1] /\ alpha in [0.001, 1] -> |F -/ E| <= 7.1526e-7 }
