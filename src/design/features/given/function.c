/* The feature 'function': the graph of a function of one or two variables. */
#include "design/features/given/equations.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"function", BATTEN_VALUE_TEXT, false, true, NULL, NULL,
     "y = f(x), x = f(y): a curve; z = f(x, y): a surface"},
    {"x", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "from where to where x goes"},
    {"y", BATTEN_VALUE_RANGE, false, false, NULL, NULL, "from where to where y goes"},
    BAT_EQUATION_WITHIN,
};

/* What stands before the '=': x, y or z; 0 for none. `*rest`: what follows it. */
static char function_of(const char *text, const char **rest)
{
    const char *at = text + strspn(text, " \t\r\n");
    const char name = *at;
    *rest = text;
    if (name < 'x' || name > 'z')
        return 0;
    at++;
    at += strspn(at, " \t\r\n");
    if (*at != '=')
        return 0;
    *rest = at + 1;
    return name;
}

/* Of the coordinates, `value` is the function and the others are the variables in order. */
static batten_status put_function(bat_run *run, const char *text, int value, int count)
{
    static const char *const axes[] = {"x", "y", "z"};
    const char *variables[2] = {NULL, NULL};
    batten_equation *read[3] = {NULL, NULL, NULL};
    batten_interval range[2];
    batten_status status = BATTEN_OK;
    for (int k = 0, n = 0; k < count; k++)
        if (k != value)
            variables[n++] = axes[k];
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        status = bat_equation(run, k == value ? text : axes[k], count - 1, variables, &read[k]);
    for (int n = 0; n < count - 1 && status == BATTEN_OK; n++)
        status = bat_equation_range(run, variables[n], &range[n]);
    if (status == BATTEN_OK)
        status = count == 2 ? bat_put_equation_curve(run, 2, read, range[0])
                            : bat_put_equation_surface(run, read, range);
    for (int k = 0; k < 3; k++)
        batten_equation_free(read[k]);
    return status;
}

static batten_status run_function(bat_run *run)
{
    const char *text;
    const char of = function_of(bat_text(run, "function"), &text);
    if (!of)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%.60s' does not begin with 'y =', 'x =' or 'z ='; for F(x, y) = 0 "
                        "there is implicit-curve",
                        text);
    const char *unused = of == 'y' ? "y" : "x";
    if (of != 'z' && bat_has(run, unused))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%s is the value of the function; a range of it has no use here",
                        unused);
    return put_function(run, text, of - 'x', of == 'z' ? 3 : 2);
}

const bat_feature bat_feature_function = {
    .shown =
        {"function", "The graph y = f(x) or z = f(x, y) of a function, with a proved error",
         "A curve is made of quintic pieces with two derivatives of f at their ends, a surface is a\n"
         "quintic spline in both directions. Interval arithmetic bounds the sixth derivatives and\n"
         "so proves that no point is off by more than 'within':\n"
         "|error| \u2264 max |f\u207d\u2076\u207e| h\u2076 / 46080 on a piece of length h.\n"
         "Polynomials up to degree 5 are exact. Corners and the ends of roots are found and said;\n"
         "a pole is refused with its place: take ranges that end before it.\n\n" BAT_EQUATION_TEXT,
         "features:\n"
         "  wave: {function: y = 0.3*sin(2*pi*x), x: [0, 3 m]}\n"
         "  saddle: {function: z = x*y/2, x: [-1 m, 1 m], y: [-1 m, 1 m]}\n",
         "[MKC09]", "batten_curve_parametric", BAT_PARAMETERS(parameters), false,
         .also = "graph, y = f(x), explicit curve, height field, plot",
         .formula = "    P(x) = (x, f(x)),  P(x, y) = (x, y, f(x, y))",
         .promise =
             "No point is farther from the graph than the error, which is proved; polynomials up to degree 5 are exact."},
    .run = run_function};
