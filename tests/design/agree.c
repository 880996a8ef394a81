/* Features beside the calls behind them: see agree.h. */
#include "design/agree.h"
#include "design/evaluate.h"

/* Places at which two curves are compared, ends included. */
enum { PLACES = 33 };

/* All that differs in a table is listed before the test fails. */
static int wrong;

static void compare(const char *feature, const char *what, double actual, double expected)
{
    if (isnan(expected) ? isnan(actual)
                        : fabs(actual - expected) <= 1e-11 * (1 + fabs(expected)))
        return;
    wrong++;
    fprintf(stderr, "a: %s\n    %s: found %.16g, expected %.16g\n", feature, what, actual,
            expected);
}

/* A point of the call's curve, where the feature has put it; of a function it may be that of the graph. */
static void lift(const agree_made *made, double u, const double *at, double *out)
{
    const int d = made->chain ? batten_chain_dimension(made->chain)
                              : batten_curve_dimension(made->curve),
              x = made->axis == 0, y = made->axis == 2 ? 1 : 2;
    if (d == 3) {
        memcpy(out, at, 3 * sizeof *out);
        return;
    }
    out[made->axis] = made->level;
    out[x] = d == 2 ? at[0] : u;
    out[y] = d == 2 ? at[1] : at[0];
}

static void compare_points(const char *feature, const batten_object *object,
                           const agree_made *made)
{
    const batten_interval domain = made->chain ? batten_chain_domain(made->chain)
                                               : batten_curve_domain(made->curve),
                          found = object->chain ? batten_chain_domain(object->chain)
                                                : batten_curve_domain(object->curve);
    compare(feature, "start of the domain", found.a, domain.a);
    compare(feature, "end of the domain", found.b, domain.b);
    for (int i = 0; i < PLACES; i++) {
        double actual[3], expected[3], own[3] = {0};
        const double u = domain.a + (domain.b - domain.a) * i / (PLACES - 1);
        if (made->chain)
            CHECK_OK(batten_chain_evaluate(made->chain, u, 0, own));
        else
            CHECK_OK(batten_curve_evaluate(made->curve, u, 0, own));
        if (object->chain)
            CHECK_OK(batten_chain_evaluate(object->chain, u, 0, actual));
        else
            CHECK_OK(batten_curve_evaluate(object->curve, u, 0, actual));
        lift(made, u, own, expected);
        for (int k = 0; k < 3; k++)
            compare(feature, "coordinate", actual[k], expected[k]);
    }
}

static void compare_made(const char *feature, const batten_feature_result *result,
                         const agree_made *made)
{
    CHECK_INT(batten_model_count(result->value), 1);
    const batten_object *object = batten_model_object(result->value, 0);
    CHECK(object->kind == BATTEN_OBJECT_CURVE &&
          (object->chain == NULL) == (made->chain == NULL));
    /* The graph of a rational function has a higher degree than the function. */
    if (made->curve && (!made->abscissae || !batten_curve_is_rational(made->curve))) {
        compare(feature, "degree", batten_curve_degree(object->curve),
                batten_curve_degree(made->curve));
        compare(feature, "control points", batten_curve_point_count(object->curve),
                batten_curve_point_count(made->curve));
    }
    compare_points(feature, object, made);
    CHECK((object->parameters == NULL) == (isnan(made->parameters[0]) != 0));
    for (int i = 0; object->parameters && i < made->points.count; i++)
        compare(feature, "parameter", object->parameters[i], made->parameters[i]);
    if (isnan(made->error)) /* a chain may be apart from its curve */
        CHECK(!result->has_error || object->chain);
    else
        CHECK(result->has_error);
    if (!isnan(made->error) && !object->chain) {
        compare(feature, "largest error", result->error_max, made->error);
        compare(feature, "root mean square", result->error_rms, made->rms);
    }
}

static void check_row(const char *before, const agree_made *data, const agree_row *row)
{
    char text[3000];
    batten_design *design = NULL;
    agree_made made = *data;
    made.error = made.rms = (double)NAN;
    for (int i = 0; i < AGREE_POINTS; i++)
        made.parameters[i] = (double)NAN;
    CHECK_OK(row->call(&made));
    snprintf(text, sizeof text, "batten: 1\nunits: m\ntolerance: 0.001\nfeatures:\n%s  a: %s\n",
             before, row->feature);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    compare_made(row->feature, batten_design_result(design, "a"), &made);
    batten_design_free(design);
    batten_curve_unref(made.curve);
    batten_chain_unref(made.chain);
}

void agree_rows(const char *before, const agree_made *data, const agree_row *rows, int count)
{
    wrong = 0;
    for (int i = 0; i < count; i++)
        check_row(before, data, &rows[i]);
    CHECK_INT(wrong, 0);
}

/* ---- surfaces ---- */

const batten_curve *agree_input(const batten_design *design, const char *feature)
{
    return batten_model_object(batten_design_result(design, feature)->value, 0)->curve;
}

static void compare_surfaces(const char *feature, const batten_surface *actual,
                             const batten_surface *expected)
{
    enum { STEPS = 8 };
    for (int k = 0; k < 2; k++) {
        const batten_direction along = k ? BATTEN_V : BATTEN_U;
        compare(feature, "start of a domain", batten_surface_domain(actual, along).a,
                batten_surface_domain(expected, along).a);
        compare(feature, "end of a domain", batten_surface_domain(actual, along).b,
                batten_surface_domain(expected, along).b);
    }
    const batten_interval u = batten_surface_domain(expected, BATTEN_U),
                          v = batten_surface_domain(expected, BATTEN_V);
    for (int i = 0; i <= STEPS; i++)
        for (int j = 0; j <= STEPS; j++) {
            double found[3], wanted[3];
            const double s = i == STEPS ? u.b : u.a + (u.b - u.a) * i / STEPS,
                         t = j == STEPS ? v.b : v.a + (v.b - v.a) * j / STEPS;
            CHECK_OK(batten_surface_evaluate(actual, s, t, 0, found));
            CHECK_OK(batten_surface_evaluate(expected, s, t, 0, wanted));
            for (int k = 0; k < 3; k++)
                compare(feature, "coordinate", found[k], wanted[k]);
        }
}

static void check_surface_row(const char *before, const agree_surface_row *row)
{
    char text[4000];
    batten_design *design = NULL;
    agree_surface made = {NULL, (double)NAN};
    snprintf(text, sizeof text, "batten: 1\nunits: m\ntolerance: 0.001\nfeatures:\n%s  a: %s\n",
             before, row->feature);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    CHECK_OK(row->call(design, &made));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK_INT(batten_model_count(result->value), 1);
    compare_surfaces(row->feature, batten_model_object(result->value, 0)->surface,
                     made.surface);
    if (!isnan(made.error)) {
        CHECK(result->has_error);
        compare(row->feature, "largest error", result->error_max, made.error);
    }
    batten_design_free(design);
    batten_surface_unref(made.surface);
}

void agree_surfaces(const char *before, const agree_surface_row *rows, int count)
{
    wrong = 0;
    for (int i = 0; i < count; i++)
        check_surface_row(before, &rows[i]);
    CHECK_INT(wrong, 0);
}
