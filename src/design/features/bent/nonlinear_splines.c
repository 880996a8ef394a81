/* The nonlinear splines that differ in the family of their spans alone: a row each. */
#include "design/shared/nonlinear.h"

#define PARAMETERS_OF(name)                                                 \
    {                                                                       \
        {name,                                                              \
         BATTEN_VALUE_MODEL,                                                \
         false,                                                             \
         true,                                                              \
         NULL,                                                              \
         NULL,                                                              \
         "a table of offsets, rows of points, or curves that have points"}, \
            BAT_EACH, BAT_NONLINEAR_ENDS, BAT_CLOSED,                       \
    }

static const batten_parameter elastica_parameters[] = PARAMETERS_OF("elastica");
static const batten_parameter euler_spiral_parameters[] = PARAMETERS_OF("euler-spiral");
static const batten_parameter geometric_spline_parameters[] = PARAMETERS_OF("geometric-spline");
static const batten_parameter hobby_parameters[] = PARAMETERS_OF("hobby");
static const batten_parameter arc_spline_parameters[] = PARAMETERS_OF("arc-spline");
static const batten_parameter local_cubic_parameters[] = PARAMETERS_OF("local-cubic");

static batten_status make_chain(bat_run *run, const bat_data *data, bat_made *made)
{
    return bat_nonlinear_make(run, data, (batten_span_family)run->family, NULL, made);
}

static batten_status draw_nonlinear(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_chain};
    return bat_through(run, &method);
}

const bat_feature bat_feature_elastica = {
    .shown =
        {"elastica", "The mechanical spline: a thin beam held at the points",
         "What a real batten does: no load acts between the ducks, so each span is an elastica and\n"
         "the bending energy is stationary. The fairest curve in that sense, but not round: points\n"
         "of a circle do not give a circle. It exists only while the beam need not bend too much:\n"
         "the angle between tangent and chord may reach 90 degrees where it is the same at both\n"
         "ends of a span, and 124 degrees where the other end lies along the chord. Beyond that\n"
         "use its near relative, euler-spiral. With 'natural' ends the beam is free at its ends.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  batten: {elastica: ducks}\n",
         "[SL section VI.3] [Utah74 paper 9] [LF73]", "batten_chain_nonlinear",
         BAT_PARAMETERS(elastica_parameters), false,
         .also =
             "mechanical spline, minimal energy curve, thin beam, physical spline, nonlinear spline, Euler elastica, duck, batten, strip",
         .formula =
             "    2 κ″ + κ³ = 0 along the arc length on each span;  κ continuous at the points",
         .promise =
             "The bending energy ∫ κ² ds is stationary among all curves through the points."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_ELASTICA};

const bat_feature bat_feature_euler_spiral = {
    .shown =
        {"euler-spiral", "Curvature linear in arc length: clothoids",
         "For roads and rails, and for any plane curve whose curvature must not change abruptly.\n"
         "Points of a circle give the circle, and a point of the curve added to the points changes\n"
         "nothing. Of all nonlinear splines it tolerates the sharpest turns: up to 176 degrees\n"
         "between tangent and chord. The curve is kept as clothoids, exactly. The whole curve\n"
         "moves when one point moves, though only a little far away; rotating or scaling the\n"
         "points rotates or scales the curve. Points that turn back on themselves are refused;\n"
         "turns beyond 120 degrees are noted.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  stakes: {points: [[0, 0], [60 m, 25 m], [130 m, 20 m], [200 m, 60 m]]}\n"
         "  road: {euler-spiral: stakes, ends: circular}\n",
         "[BF15]", "batten_chain_nonlinear", BAT_PARAMETERS(euler_spiral_parameters), false,
         .also = "clothoid, Cornu spiral, transition curve, railway spiral, Bertolazzi Frego",
         .formula =
             "    θ(s) = θ_i + κ_i s + κ′_i s²/2,  P(s) = P_i + ∫ (cos θ, sin θ) ds on each span;  κ continuous at the points",
         .promise =
             "Curvature is linear in arc length on each span and continuous; points of a circle give the circle."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_EULER_SPIRAL};

const bat_feature bat_feature_geometric_spline = {
    .shown =
        {"geometric-spline", "Curvature linear along each chord",
         "The beam without the assumption of small slopes, but with loads at right angles to each\n"
         "chord: curvature is linear in the abscissa along the chord. It lies between cubic\n"
         "functions and the elastica, and it is round: points of a circle give the circle.\n"
         "Tangents stay below a right angle from the chord; use euler-spiral where they do not.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 10 cm]]}\n"
         "  batten: {geometric-spline: ducks}\n",
         "[SL section VI.1]", "batten_chain_nonlinear",
         BAT_PARAMETERS(geometric_spline_parameters), false,
         .also = "linear curvature along the chord",
         .formula =
             "    κ(ξ) = a + b ξ along the chord, 0 ≤ ξ ≤ l;  sin(θ − φ) = sin α + a ξ + b ξ²/2;  κ continuous at the points",
         .promise =
             "Curvature is continuous and linear in the abscissa of each chord; points of a circle give the circle."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_GEOMETRIC};

const bat_feature bat_feature_hobby = {
    .shown =
        {"hobby", "The curves of Metafont and MetaPost",
         "One cubic for each span, from one linear system: curvature is linearised for small\n"
         "angles, and the tangent lengths are Hobby's. Quick, and pleasing for letters and\n"
         "drawings; a circle through four points is off by 0.03 percent. Curvature has small steps\n"
         "at the points; use euler-spiral where it must be continuous. 'ends: circular' is the\n"
         "curl of 1 that is Metafont's default.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  nodes: {points: [[0, 0], [1 m, 60 cm], [2 m, 40 cm], [1.5 m, -30 cm]]}\n"
         "  letter: {hobby: nodes, closed: yes}\n",
         "[Hobby86]", "batten_chain_nonlinear", BAT_PARAMETERS(hobby_parameters), false,
         .also = "Metafont, MetaPost, mock curvature, Knuth, TikZ curve",
         .formula =
             "    (2 α_{i−1} + 4 β_{i−1})/l_{i−1} + (4 α_i + 2 β_i)/l_i = 0,  legs l ρ(α, −β) and l ρ(−β, α)\n"
             "    ρ(θ, φ) = (2 + √2 (sin θ − sin φ/16) (sin φ − sin θ/16) (cos θ − cos φ)) / (3 + (3/2)(√5 − 1) cos θ + (3/2)(3 − √5) cos φ)",
         .promise = "Tangents are continuous; the linearised curvature is, too."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_HOBBY};

const bat_feature bat_feature_arc_spline = {
    .shown =
        {"arc-spline", "One circular arc at each point, joined tangentially",
         "For machines and templates with the fewest arcs: each point lies inside its own arc, and\n"
         "neighbouring arcs meet on the perpendicular bisector of the chord between them. Points\n"
         "of a circle give the circle. Curvature is a step function; where the points wind the\n"
         "steps are large, and biarcs are more even.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 80 cm], [3 m, 30 cm]]}\n"
         "  template: {arc-spline: ducks, ends: circular}\n",
         "[SL section VI.6]", "batten_chain_nonlinear", BAT_PARAMETERS(arc_spline_parameters),
         false, .also = "circular spline, arc spline, one arc at each point",
         .formula =
             "    k0 = −(4/l) sin((3α + β)/4) cos((α − β)/4),  k1 = (4/l) sin((α + 3β)/4) cos((α − β)/4)\n"
             "    k1 of span i − 1 = k0 of span i: one arc at each point, joints on the bisectors of the chords",
         .promise = "Tangents are continuous; points of a circle give the circle."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_ARCS};

const bat_feature bat_feature_local_cubic = {
    .shown =
        {"local-cubic", "A cubic function over each chord, curvature continuous",
         "The cubic spline function, but with each span measured from its own chord, so that steep\n"
         "and closed curves are possible and the result rotates with the points. It suits smooth\n"
         "data with turns below some 60 degrees; the result consists of exact cubics. Where the\n"
         "points bend little it is the natural cubic spline. Tangents stay below a right angle\n"
         "from the chord, and beyond 35 degrees the equations become ill-conditioned: use\n"
         "euler-spiral there. Points at equal steps of a circle give its tangents, and a curvature\n"
         "that is too small by the square of half the turn.\n\n" BAT_NONLINEAR_ENDS_TEXT,
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm]]}\n"
         "  batten: {local-cubic: ducks}\n",
         "[SL section VI.2]", "batten_chain_nonlinear", BAT_PARAMETERS(local_cubic_parameters),
         false, .also = "local cubic spline, local coordinates, secant frame",
         .formula =
             "    η = ξ (1 − t) (tan α (1 − t) − tan β · t),  t = ξ/l, over the chord;  κ continuous at the points",
         .promise = "Curvature is continuous; the shape does not depend on the axes."},
    .run = draw_nonlinear,
    .family = BATTEN_FAMILY_LOCAL_CUBIC};
