#include "design/feature.h"

#include <batten/blend.h>

/* The words of 'ends' behind 'nearest'. */
static const batten_curve_end pairs[4][2] = {{BATTEN_CURVE_END, BATTEN_CURVE_START},
                                             {BATTEN_CURVE_END, BATTEN_CURVE_END},
                                             {BATTEN_CURVE_START, BATTEN_CURVE_START},
                                             {BATTEN_CURVE_START, BATTEN_CURVE_END}};

static const batten_parameter parameters[] = {
    {"blend", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "two curves"},
    {"ends", BATTEN_VALUE_WORD, false, false, "nearest",
     "nearest end-start end-end start-start start-end",
     "from which end of the first to which of the second"},
    {"first", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the first curve: place, tangent, curvature, rate of curvature"},
    {"second", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the second curve"},
    {"bulge", BATTEN_VALUE_NUMBER, true, false, "1", NULL,
     "how far it goes on along the curves before it turns, one factor or one for either end"},
    {"whole", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the curves and the blend as one, from the far end of the first"},
};

static batten_status ends_of(const bat_run *run, const batten_curve *const curves[2],
                             batten_blend_end ends[2])
{
    const bat_argument *bulge = bat_argument_of(run, "bulge");
    batten_curve_end at[2];
    batten_status status = BATTEN_OK;
    if (bulge->count > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'bulge' has %d factors, at most 2 are used",
                        bulge->count);
    const int word = bat_word(run, "ends");
    if (word == 0)
        status = batten_curves_nearest_ends(curves[0], curves[1], at);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        ends[k] =
            (batten_blend_end){.end = word ? pairs[word - 1][k] : at[k],
                               .continuity = bat_word(run, k ? "second" : "first"),
                               .bulge = bulge->items[bulge->count == 2 ? k : 0].number[0]};
    return status;
}

/* A curve run towards its named end, or away from it. */
static batten_status turned(const batten_curve *curve, bool reverse, batten_curve **out)
{
    if (reverse)
        return batten_curve_reverse(curve, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

static batten_status join_all(const batten_curve *const curves[2],
                              const batten_blend_end ends[2], const batten_curve *blend,
                              double within, batten_curve **out)
{
    batten_curve *first = NULL, *second = NULL, *half = NULL;
    batten_status status = turned(curves[0], ends[0].end == BATTEN_CURVE_START, &first);
    if (status == BATTEN_OK)
        status = turned(curves[1], ends[1].end == BATTEN_CURVE_END, &second);
    if (status == BATTEN_OK)
        status = batten_curve_join(first, blend, within, &half);
    if (status == BATTEN_OK)
        status = batten_curve_join(half, second, within, out);
    batten_curve_unref(half);
    batten_curve_unref(second);
    batten_curve_unref(first);
    return status;
}

static batten_status blend(bat_run *run, const batten_curve *const curves[2],
                           batten_curve **out)
{
    batten_blend_end ends[2];
    batten_blend_report report;
    batten_curve *made = NULL;
    batten_status status = ends_of(run, curves, ends);
    if (status == BATTEN_OK)
        status = batten_curves_blend(curves[0], &ends[0], curves[1], &ends[1], &report, &made);
    if (status != BATTEN_OK)
        return status;
    bat_note(run, "joins with G%d and G%d", report.joins[0].geometric,
             report.joins[1].geometric);
    if (bat_yes(run, "whole"))
        status = join_all(curves, ends, made, bat_tolerance(run), out);
    else
        *out = batten_curve_ref(made);
    batten_curve_unref(made);
    return status;
}

static batten_status run(bat_run *run)
{
    bat_objects all;
    batten_status status = bat_gather(run, "blend", BAT_CURVES, &all);
    batten_curve *made = NULL;
    if (status != BATTEN_OK)
        return status;
    if (all.count != 2) {
        status =
            bat_fail(BATTEN_NOT_COMPATIBLE, "two curves are needed, there are %d", all.count);
    } else {
        const batten_curve *const curves[2] = {all.at[0]->curve, all.at[1]->curve};
        status = blend(run, curves, &made);
    }
    bat_objects_release(&all);
    return bat_put_curve(run, status, made);
}

const bat_feature bat_feature_blend = {
    .shown =
        {"blend", "A curve between the ends of two curves that goes over smoothly into both",
         "A single Bezier curve of the least degree, 1 to 7, that has the tangent, the\n"
         "curvature and its rate of the curves as far as 'first' and 'second' ask. The two\n"
         "curves stay as they are. A bulge above 1 makes the blend follow the curve longer,\n"
         "below 1 turn sooner; where the ends are far apart for how sharply the curves bend,\n"
         "smaller bulges, or G1, help. The joins are measured, and a note says what they are.\n"
         "Ends that already meet are the business of 'match'.",
         "features:\n"
         "  aft: {line: [[0, 0], [2 m, 0.2 m]]}\n"
         "  fore: {line: [[4 m, 1.5 m], [5 m, 3 m]]}\n"
         "  bilge: {blend: [aft, fore], first: G3, bulge: [1, 0.8]}\n",
         "[BD89]", "batten_curves_blend", BAT_PARAMETERS(parameters), false},
    .run = run};
