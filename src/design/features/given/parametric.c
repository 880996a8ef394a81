/* The feature 'parametric': a curve or surface given by its coordinates. */
#include "design/features/given/equations.h"

static const batten_parameter parameters[] = {
    {"parametric", BATTEN_VALUE_TEXT, true, true, NULL, NULL,
     "[x, y] or [x, y, z]: a curve in t; [x, y, z]: a surface in u and v"},
    {"t", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "of a curve: from where to where"},
    {"u", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "of a surface"},
    {"v", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "of a surface"},
    BAT_EQUATION_WITHIN,
};

static batten_status check_ranges(const bat_run *run, int count)
{
    const bool t = bat_has(run, "t"), u = bat_has(run, "u"), v = bat_has(run, "v");
    if (t == (u || v) || u != v)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a curve needs t: [a, b]; a surface needs u: [a, b] and v: [c, d]");
    if (count < (t ? 2 : 3) || count > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d coordinates; a %s", count,
                        t ? "curve has 2 or 3" : "surface has 3");
    return BATTEN_OK;
}

static batten_status run_parametric(bat_run *run)
{
    static const char *const curve[] = {"t"}, *const surface[] = {"u", "v"};
    const bat_argument *given = bat_argument_of(run, "parametric");
    const bool is_curve = bat_has(run, "t");
    batten_equation *read[3] = {NULL, NULL, NULL};
    batten_interval range[2];
    batten_status status = check_ranges(run, given->count);
    for (int k = 0; k < given->count && status == BATTEN_OK; k++)
        status = bat_equation(run, given->items[k].text, is_curve ? 1 : 2,
                              is_curve ? curve : surface, &read[k]);
    for (int n = 0; n < (is_curve ? 1 : 2) && status == BATTEN_OK; n++)
        status = bat_equation_range(run, is_curve ? curve[n] : surface[n], &range[n]);
    if (status == BATTEN_OK)
        status = is_curve ? bat_put_equation_curve(run, given->count, read, range[0])
                          : bat_put_equation_surface(run, read, range);
    for (int k = 0; k < 3; k++)
        batten_equation_free(read[k]);
    return status;
}

const bat_feature bat_feature_parametric = {
    .shown =
        {"parametric",
         "A curve or surface by its coordinates x(t), y(t), z(t), with a proved error",
         "As 'function': quintic pieces between which two derivatives continue, with\n"
         "|error| \u2264 max |P\u207d\u2076\u207e| h\u2076 / 46080, proved by interval arithmetic.\n"
         "The parameter of the curve is t. Places where all first derivatives may vanish (cusps) and\n"
         "where one does not exist are found and said.\n\n" BAT_EQUATION_TEXT,
         "features:\n"
         "  spiral: {parametric: [5*cos(t), 5*sin(t), t/5], t: [0, =8*pi]}\n"
         "  tube: {parametric: [cos(u), sin(u), v + sin(2*u)/4], u: [0, =2*pi], v: [0, 3]}\n",
         "[MKC09]", "batten_curve_parametric", BAT_PARAMETERS(parameters), false,
         .also = "equation curve, equation surface, law curve, x(t), y(t), z(t)",
         .formula = "    P(t) = (x(t), y(t), z(t)),  P(u, v) = (x(u, v), y(u, v), z(u, v))",
         .promise =
             "Points of equal parameters are no farther apart than the error, which is proved."},
    .run = run_parametric};
