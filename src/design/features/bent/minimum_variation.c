/* The feature 'minimum-variation': the curve whose curvature varies least. */
#include "design/features/bent/energy.h"

static const batten_parameter parameters[] = {
    {"minimum-variation", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_ENERGY_PARAMETERS,
};

const bat_feature bat_feature_minimum_variation = {
    .shown =
        {"minimum-variation", "The curve whose curvature varies least",
         "Quintics with continuous curvature; the integral of the squared rate of curvature is a\n"
         "minimum near Spiro's curve through the points. Points on a circle give the circle to a\n"
         "few parts in a thousand million; ends are free and take the curvature that suits the\n"
         "rest. In space the turning of the normal counts as well. Where a curve would vary less\n"
         "and less by growing, a tension holds it, as with minimum-energy, and a remark says so.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 10 cm]]}\n"
         "  strip: {minimum-variation: ducks}\n",
         "[MS92]", "batten_curve_minimum_energy", BAT_PARAMETERS(parameters), false,
         .also = "MVC, minimum variation curve, Moreton Sequin, fair curve",
         .formula = "    ∫ (dκ/ds)² ds → minimum in the plane;  ∫ (κ′² + κ² τ²) ds in space",
         .promise =
             "Points of a circle give the circle; the least of quintics with continuous curvature near the start."},
    .run = bat_least_energy};
