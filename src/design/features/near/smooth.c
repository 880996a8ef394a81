/* The feature 'smooth': the smoothing spline: a batten tied to its points by springs. */
#include "design/shared/near.h"

static const batten_parameter parameters[] = {
    {"smooth", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "points, or a table of offsets"},
    {"rms", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the root of the mean squared distance that may be left"},
    {"lambda", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "how much bending weighs against distance, instead of 'rms'"},
    {"order", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "1 to 4: which derivative is kept small"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make_smooth(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_smooth_options options = batten_curve_smooth_defaults();
    return bat_make_smooth(run, data, batten_curve_smooth, &options, made);
}

static batten_status run_smooth(bat_run *run)
{
    return bat_through(
        run,
        &(bat_method){.least = 2, .ways = BAT_IN_SPACE | BAT_AS_FUNCTION, .make = make_smooth});
}

const bat_feature bat_feature_smooth = {
    .shown =
        {"smooth", "The smoothing spline: a batten tied to its points by springs",
         "There is a knot at every point, and the curve gives way to noise: 'rms' says how far, as\n"
         "a length, or 'lambda' how stiff the batten is (0 interpolates, a huge value gives the\n"
         "straight line). Without either, cross validation chooses the stiffness with which each\n"
         "point is predicted best from the others, which needs some thirty points whose errors are\n"
         "independent. Use 'order: 3' where curvature should vary gently. Corners are rounded;\n"
         "single bad points show as bumps.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 19 cm], [2 m, 31 cm], [3 m, 42 cm], [4 m, 41 cm], [5 m, 33 cm], [6 m, 22 cm]]}\n"
         "  sheer: {smooth: marks, rms: 1 cm}\n",
         "[Reinsch67]", "batten_curve_smooth", BAT_PARAMETERS(parameters), false,
         .also = "smoothing spline, Reinsch, cross validation, noise, penalty",
         .formula = "    Σ w_j |S(t_j) − Q_j|² + λ ∫ |S^(m)|² dt → minimum,  m = order",
         .promise =
             "The least of all curves: a natural spline of degree 2m − 1 with a knot at every parameter."},
    .run = run_smooth};
