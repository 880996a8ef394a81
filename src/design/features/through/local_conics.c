/* The feature 'local-conics': one conic between two points, tangents continuous. */
#include "design/shared/conics.h"
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"local-conics", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_CONIC_TANGENTS,
    {"weight", BATTEN_VALUE_NUMBER, false, false, "0", NULL,
     "below 1 ellipses, 1 parabolas, above 1 hyperbolas; 0: circles where there are any"},
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_local_conics(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_conics_options options = batten_curve_conics_defaults();
    double *tangents = NULL;
    options.kind = BATTEN_CONICS_SINGLE;
    options.closed = bat_yes(run, "closed");
    options.weight = bat_number(run, "weight");
    batten_status status = bat_vectors(run, data, "tangents", &tangents);
    options.tangents = tangents;
    if (status == BATTEN_OK)
        status = bat_conics_make(run, data, &options, made);
    bat_release(tangents);
    return status;
}

static batten_status run_local_conics(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_local_conics};
    return bat_through(run, &method);
}

const bat_feature bat_feature_local_conics = {
    .shown =
        {"local-conics", "One conic between two points, tangents continuous",
         "For fuselage and hull sections as they were drawn with conics, and where a curve must\n"
         "not bend more often than its tangents do: one conic between two points, in the triangle\n"
         "of its tangents. The weight makes it full or flat; without one, points of a circle give\n"
         "the circle. Tangents come from circles through three points, or are given. Curvature\n"
         "jumps at the points; use 'conic-spline' where it must not. A span that bends to both\n"
         "sides is two conics that meet on the chord; one whose tangents do not meet near it is a\n"
         "biarc; both are noted. The points lie in a plane.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm]]}\n"
         "  section: {local-conics: ducks, weight: 0.8}\n",
         "[SL section VI.5] [PT97 section 9.3.3]", "batten_curve_conics",
         BAT_PARAMETERS(parameters), false,
         .also = "Liming, conic lofting, rho conics, fuselage sections, second degree curves",
         .formula =
             "    C(t) = (B0 P0 + w B1 T + B2 P3)/(B0 + w B1 + B2),  B_i = Bernstein polynomials of degree 2",
         .promise =
             "Tangents are continuous and each span stays in the triangle of its tangents; points of a circle give the circle."},
    .run = run_local_conics};
