/*
 * Taylor arithmetic in two variables: a number together with its partial derivatives in u and v
 * up to total order 3. A formula written once in jets gives a surface and all its derivatives,
 * exact but for rounding.
 *
 * Derivatives stand in the order of BATTEN_SURFACE_DERIVATIVE: f; fu, fv; fuu, fuv, fvv; fuuu,
 * fuuv, fuvv, fvvv. All ten are always computed.
 */
#ifndef BAT_JET_H
#define BAT_JET_H

#define BAT_JET_SIZE 10

typedef struct {
    double d[BAT_JET_SIZE];
} bat_jet;

bat_jet bat_jet_constant(double value);
bat_jet bat_jet_u(double u); /* the variables themselves */
bat_jet bat_jet_v(double v);

bat_jet bat_jet_add(bat_jet a, bat_jet b);
bat_jet bat_jet_subtract(bat_jet a, bat_jet b);
bat_jet bat_jet_scale(double factor, bat_jet a);
bat_jet bat_jet_multiply(bat_jet a, bat_jet b);
/* The caller sees to it that b is not 0. */
bat_jet bat_jet_divide(bat_jet a, bat_jet b);
bat_jet bat_jet_square_root(bat_jet a); /* a > 0 */
/* g(a), where `g` [4] holds g and its first three derivatives at the value of a. So the point
 * of a curve at a parameter that is itself a jet, one coordinate at a time. */
bat_jet bat_jet_compose(const double g[4], bat_jet a);

#endif
