#include "design/pair.h"

#include <batten/blend.h>

static const batten_parameter parameters[] = {
    {"blend", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "two curves"},
    BAT_PAIR_ENDS,
    {"first", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the first curve: place, tangent, curvature, rate of curvature"},
    {"second", BATTEN_VALUE_WORD, false, false, "G2", "G0 G1 G2 G3",
     "how it joins the second curve"},
    {"bulge", BATTEN_VALUE_NUMBER, true, false, "1", NULL,
     "how far it goes on along the curves before it turns, one factor or one for either end"},
    {"whole", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the curves and the blend as one, from the far end of the first"},
};

static batten_status blend(bat_run *run, const batten_curve *const curves[2],
                           batten_curve **out)
{
    const bat_argument *bulge = bat_argument_of(run, "bulge");
    batten_blend_end ends[2];
    batten_blend_report report;
    batten_curve *made = NULL;
    if (bulge->count > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'bulge' has %d factors, at most 2 are used",
                        bulge->count);
    for (int k = 0; k < 2; k++)
        ends[k] =
            (batten_blend_end){.end = k ? BATTEN_CURVE_START : BATTEN_CURVE_END,
                               .continuity = bat_word(run, k ? "second" : "first"),
                               .bulge = bulge->items[bulge->count == 2 ? k : 0].number[0]};
    batten_status status =
        batten_curves_blend(curves[0], &ends[0], curves[1], &ends[1], &report, &made);
    if (status != BATTEN_OK)
        return status;
    bat_remark(run, "joins with G%d and G%d", report.joins[0].geometric,
               report.joins[1].geometric);
    const double u[2] = {batten_curve_domain(curves[0]).b, batten_curve_domain(curves[1]).a};
    if (bat_yes(run, "whole"))
        status = bat_pair_join(curves, u, made, bat_tolerance(run), out);
    else
        *out = batten_curve_ref(made);
    batten_curve_unref(made);
    return status;
}

static batten_status run(bat_run *run)
{
    batten_curve *curves[2] = {NULL, NULL}, *made = NULL;
    batten_status status = bat_pair_take(run, "blend", curves);
    if (status == BATTEN_OK)
        status = blend(run, (const batten_curve *const *)curves, &made);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
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
