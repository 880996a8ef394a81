/* The feature 'line': the straight line between two points. */
#include "design/feature.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"line", BATTEN_VALUE_POINT, true, true, NULL, NULL, "both ends"},
};

static batten_status run_line(bat_run *run)
{
    const bat_argument *ends = bat_argument_of(run, "line");
    batten_curve *line = NULL;
    if (ends->count != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a line has 2 ends, not %d", ends->count);
    const batten_status status =
        batten_curve_line(3, ends->items[0].number, ends->items[1].number, &line);
    return bat_put_curve(run, status, line);
}

const bat_feature bat_feature_line = {
    .shown = {"line", "The straight line between two points",
              "A curve of degree 1 from the first point to the second.",
              "features:\n"
              "  keel: {line: [[0, 0, 0], [12 m, 0, 0]]}\n",
              "", "batten_curve_line", BAT_PARAMETERS(parameters), false,
              .also = "segment, straight", .formula = "    C(t) = (1 − t) A + t B",
              .promise = "It is exact."},
    .run = run_line};
