/* The feature 'spiro': curvature cubic in arc length, joined as smoothly as each point
 * asks. */
#include "design/shared/through.h"
#include <batten/bent.h>

#define END_WORDS "free natural tangent curvature both"

static const batten_parameter parameters[] = {
    {"spiro", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    {"curvature", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points at which only direction and curvature continue, counted from 1"},
    {"corners", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points where the direction may jump, counted from 1"},
    {"left", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "one-way points: what comes before is not affected by what follows"},
    {"right", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "one-way points: what follows is not affected by what comes before"},
    {"ends", BATTEN_VALUE_WORD, false, false, "free", END_WORDS,
     "what holds at both ends: curvature does not change, is 0, or what is given"},
    {"start", BATTEN_VALUE_WORD, false, false, NULL, END_WORDS, "what holds at the start"},
    {"start-angle", BATTEN_VALUE_ANGLE, false, false, "0", NULL,
     "direction of a tangent given at the start, from the first axis of the plane"},
    {"start-curvature", BATTEN_VALUE_NUMBER, false, false, "0", NULL,
     "a curvature given at the start, 1 by the unit; above 0 to the left"},
    {"end", BATTEN_VALUE_WORD, false, false, NULL, END_WORDS, "what holds at the end"},
    {"end-angle", BATTEN_VALUE_ANGLE, false, false, "0", NULL,
     "direction of a tangent given at the end"},
    {"end-curvature", BATTEN_VALUE_NUMBER, false, false, "0", NULL,
     "a curvature given at the end"},
    BAT_CLOSED,
};

static batten_spiro_end end_of(const bat_run *run, const char *end, const char *angle,
                               const char *curvature)
{
    enum { FREE, NATURAL, TANGENT, CURVATURE, BOTH };
    const int word = (int)bat_word(run, bat_has(run, end) ? end : "ends");
    return (batten_spiro_end){
        .has_tangent = word == TANGENT || word == BOTH,
        .has_curvature = word >= NATURAL && word != TANGENT,
        .tangent = bat_number(run, angle),
        .curvature = word == NATURAL ? 0 : bat_number(run, curvature),
    };
}

static batten_status set_point_kind(const char *list, batten_spiro_kind kind, int i, int count,
                                    batten_spiro_kind *kinds)
{
    if (i >= count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' names point %d of %d", list, i + 1, count);
    if (kinds[i] != BATTEN_SPIRO_SMOOTH && kinds[i] != kind)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' names point %d, which another list names too", list, i + 1);
    kinds[i] = kind;
    return BATTEN_OK;
}

static batten_status set_kind(const bat_run *run, const char *list, batten_spiro_kind kind,
                              int count, batten_spiro_kind *kinds)
{
    int listed = 0, *points = NULL;
    batten_status status = bat_indices(run, list, &listed, &points);
    for (int k = 0; k < listed && status == BATTEN_OK; k++)
        status = set_point_kind(list, kind, points[k], count, kinds);
    bat_release(points);
    return status;
}

static const struct {
    const char *list;
    batten_spiro_kind kind;
} lists[] = {{"curvature", BATTEN_SPIRO_CURVATURE},
             {"corners", BATTEN_SPIRO_CORNER},
             {"left", BATTEN_SPIRO_LEFT},
             {"right", BATTEN_SPIRO_RIGHT}};

static batten_status find_kinds(const bat_run *run, int count, batten_spiro_kind *kinds)
{
    batten_status status = BATTEN_OK;
    for (int l = 0; l < 4 && status == BATTEN_OK; l++)
        status = set_kind(run, lists[l].list, lists[l].kind, count, kinds);
    return status;
}

static batten_status make_spiro(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    batten_spiro_kind *kinds = bat_array((size_t)data->count, sizeof *kinds);
    if (!kinds)
        return BATTEN_OUT_OF_MEMORY;
    options.kinds = kinds;
    options.closed = bat_yes(run, "closed");
    options.start = end_of(run, "start", "start-angle", "start-curvature");
    options.end = end_of(run, "end", "end-angle", "end-curvature");
    batten_status status = find_kinds(run, data->count, kinds);
    if (status == BATTEN_OK)
        status = batten_chain_spiro((batten_points){2, data->count, data->points}, &options,
                                    made->parameters, NULL, &made->chain);
    bat_release(kinds);
    return status;
}

static batten_status run_spiro(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_spiro};
    return bat_through(run, &method);
}

const bat_feature bat_feature_spiro = {
    .shown =
        {"spiro", "Curvature cubic in arc length, joined as smoothly as each point asks",
         "For outlines drawn with few points: letters, keels, handles. At ordinary points\n"
         "curvature and its first two derivatives are continuous, which is smoother than the eye\n"
         "can tell; points of a circle give the circle, and the curve is near that of\n"
         "'minimum-variation' at a fraction of its cost. At the points in 'curvature' only\n"
         "direction and curvature are continuous: moving a point then moves less of the curve, and\n"
         "sharp turns are tolerated better. The points in 'corners' separate one curve from the\n"
         "next, and a span between two corners or ends is a straight line. One-way points join a\n"
         "line to a curve: the points in 'left' have the line before them, those in 'right' after\n"
         "them; the line stays straight, and the curve leaves it with curvature 0. Ends are\n"
         "'free', which suits arcs; 'natural' is curvature 0, and restrains a wild curve better;\n"
         "'tangent' takes 'start-angle' and 'end-angle', 'curvature' takes 'start-curvature' and\n"
         "'end-curvature', 'both' takes both. Points must lie in a plane. Where they turn sharply\n"
         "one after another no such curve exists: the message names the span and what would work\n"
         "there.",
         "features:\n"
         "  points: {points: [[0, 0], [3, 0], [4.5, 0.5], [5, 2], [4, 3.2], [1, 4]]}\n"
         "  handle: {spiro: points, left: [2], right: [5]}\n",
         "[Levien09]", "batten_chain_spiro", BAT_PARAMETERS(parameters), false,
         .also = "Levien, Raph Levien, G4 spline, font outlines, type design",
         .formula =
             "    κ(s) = k0 + k1 s + k2 s²/2 + k3 s³/6 on each span;  κ, κ′, κ″ continuous at ordinary points",
         .promise =
             "Curvature and its first two derivatives are continuous at ordinary points; points of a circle give the circle."},
    .run = run_spiro};
