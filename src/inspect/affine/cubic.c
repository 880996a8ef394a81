/* Which kind of cubic a span is, by the signs of exact invariants. */
#include "inspect/affine/cubic.h"
#include "base/work.h"
#include "numeric/vector.h"

/* ---- names ---- */

#define WORD(name, word, text) word,
#define TEXT(name, word, text) text,

const char *batten_cubic_class_name(batten_cubic_class kind)
{
    static const char *const words[] = {BATTEN_CUBIC_CLASS_TABLE(WORD)};
    return (unsigned)kind < BATTEN_CUBIC_CLASS_COUNT ? words[kind] : "unknown";
}

const char *batten_cubic_class_text(batten_cubic_class kind)
{
    static const char *const texts[] = {BATTEN_CUBIC_CLASS_TABLE(TEXT)};
    return (unsigned)kind < BATTEN_CUBIC_CLASS_COUNT ? texts[kind] : "unknown";
}

/* ---- lines ---- */

/* Where the speed along a line changes sign. With edges e1, e2, e3 along it the speed is 3 (e1
 * (1-t)^2 + 2 e2 t (1-t) + e3 t^2): the roots of a form with A = e1, B = 2 e2, C = e3. */
static void look_at_line(bat_cubic *c, double tolerance, batten_cubic *out)
{
    int axis = 0, signs[BAT_FORM_COUNT];
    double relative[BAT_FORM_COUNT];
    bat_cubic line = {.has_exact = true};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            if (fabs(c->edge[i][k]) > line.longest) {
                line.longest = fabs(c->edge[i][k]);
                axis = k;
            }
    for (int i = 0; i < 3; i++) {
        const bat_exact edge = bat_exact_difference(c->point[i + 1][axis], c->point[i][axis]);
        line.abc[i] = (i == 1 ? 2 : 1) * c->edge[i][axis];
        line.bound[i] = 0x1p-53 * fabs(line.abc[i]);
        line.exact[i].count = 0;
        bat_exact_add(&line.exact[i], i == 1 ? 2 : 1, &edge);
    }
    for (int k = 0; k < BAT_FORM_COUNT; k++)
        signs[k] = bat_cubic_sign(&line, k, tolerance, &relative[k]);
    const batten_cubic_class turns = bat_cubic_segment_class(signs);
    const bool back =
        turns == BATTEN_CUBIC_ONE_INFLECTION || turns == BATTEN_CUBIC_TWO_INFLECTIONS;
    /* The whole line: the speed is a quadratic with real roots apart, or linear. */
    const bool whole_back =
        signs[BAT_FORM_LEAD] ? signs[BAT_FORM_D] > 0 : signs[BAT_FORM_FIRST] != 0;
    out->segment = back ? BATTEN_CUBIC_RETRACED_LINE : BATTEN_CUBIC_LINE;
    out->whole = whole_back ? BATTEN_CUBIC_RETRACED_LINE : BATTEN_CUBIC_LINE;
    out->margin = bat_cubic_margin(signs, relative, bat_cubic_segment_class);
    out->whole_margin = bat_min(relative[BAT_FORM_LEAD], relative[BAT_FORM_D]);
}

/* ---- parameters ---- */

/* The roots of A (1-t)^2 + B t (1-t) + C t^2 that are finite; D >= 0. */
static void find_inflections(const double *abc, bool is_explicit, double D, batten_cubic *out)
{
    const double a = abc[0], b = abc[1], c = abc[2];
    const double w = -(b + copysign(sqrt(bat_max(D, 0)), b)) / 2;
    if (is_explicit) {
        /* A + (B - 2 A) t */
        out->inflections[out->inflection_count++] = a / (2 * a - b);
        return;
    }
    double t[2] = {w / (w + c), a / (a + w)};
    if (w == 0)
        t[0] = t[1] = a == 0 ? 0 : 1;
    out->inflection_count = 2;
    out->inflections[0] = bat_min(t[0], t[1]);
    out->inflections[1] = bat_max(t[0], t[1]);
}

static void find_double_point(const double *abc, double D, batten_cubic *out)
{
    const double lead = abc[0] - abc[1] + abc[2];
    const double middle = (2 * abc[0] - abc[1]) / (2 * lead);
    const double half = sqrt(3 * -bat_min(D, 0)) / (2 * fabs(lead));
    const double product =
        (abc[0] * abc[0] - abc[0] * abc[1] + abc[1] * abc[1] - 3 * abc[0] * abc[2]) /
        (lead * lead);
    /* The larger root first, the other by their product: nothing is lost where one is near 0.
     */
    const double far = middle + copysign(half, middle), near = far != 0 ? product / far : 0;
    out->crossing[0] = bat_min(near, far);
    out->crossing[1] = bat_max(near, far);
}

static void find_parameters(const bat_cubic *c, batten_cubic *out)
{
    double size;
    const double D = bat_cubic_value(BAT_FORM_D, c->abc, &size);
    const double lead = c->abc[0] - c->abc[1] + c->abc[2];
    switch (out->whole) {
    case BATTEN_CUBIC_EXPLICIT:
    case BATTEN_CUBIC_TWO_INFLECTIONS:
        find_inflections(c->abc, out->whole == BATTEN_CUBIC_EXPLICIT, D, out);
        break;
    case BATTEN_CUBIC_CUSP:
        out->cusp = (2 * c->abc[0] - c->abc[1]) / (2 * lead);
        break;
    case BATTEN_CUBIC_LOOP:
        find_double_point(c->abc, D, out);
        break;
    default:
        break;
    }
}

static void measure_cubic(const bat_cubic *c, batten_cubic *out)
{
    const double *abc = c->abc, area = c->scale * c->scale;
    out->flatness = bat_largest(3, abc) / (c->longest * c->longest);
    out->a = abc[0] / area;
    out->b = abc[1] / area;
    out->c = abc[2] / area;
    out->p = 36 * (abc[0] - abc[1] + abc[2]) / area;
    out->q = 18 * (2 * abc[0] - abc[1]) / area;
    out->r = 18 * abc[0] / area;
    if (out->whole == BATTEN_CUBIC_TWO_INFLECTIONS || out->whole == BATTEN_CUBIC_CUSP ||
        out->whole == BATTEN_CUBIC_LOOP) {
        double size;
        const double lead = abc[0] - abc[1] + abc[2];
        out->invariant = out->whole == BATTEN_CUBIC_CUSP
                             ? 0
                             : bat_cubic_value(BAT_FORM_D, abc, &size) / (4 * lead * lead);
    }
    out->has_tangents = abc[1] != 0 && abc[0] + abc[1] != 0 && abc[1] + abc[2] != 0;
    if (out->has_tangents) {
        out->lambda = abc[1] / (abc[1] + abc[2]);
        out->mu = abc[1] / (abc[0] + abc[1]);
    }
}

static batten_cubic blank(void)
{
    return (batten_cubic){.to = 1,
                          .invariant = NAN,
                          .inflections = {NAN, NAN},
                          .cusp = NAN,
                          .crossing = {NAN, NAN},
                          .double_point = {NAN, NAN, NAN},
                          .lambda = NAN,
                          .mu = NAN};
}

static void look_at_plane(bat_cubic *c, double tolerance, batten_cubic *out)
{
    int signs[BAT_FORM_COUNT];
    double relative[BAT_FORM_COUNT];
    bat_cubic_begin(c);
    if (c->longest == 0) {
        out->whole = out->segment = BATTEN_CUBIC_POINT;
        return;
    }
    if (bat_cubic_is_line(c, tolerance)) {
        look_at_line(c, tolerance, out);
        return;
    }
    for (int k = 0; k < BAT_FORM_COUNT; k++)
        signs[k] = bat_cubic_sign(c, k, tolerance, &relative[k]);
    out->segment = bat_cubic_segment_class(signs);
    out->whole = bat_cubic_whole_class(signs);
    out->margin = bat_cubic_margin(signs, relative, bat_cubic_segment_class);
    out->whole_margin = bat_cubic_margin(signs, relative, bat_cubic_whole_class);
    measure_cubic(c, out);
    find_parameters(c, out);
}

/* ---- cubics in space ---- */

/* The coordinate to leave out so that a plane cubic is seen as large as can be: that of the
 * largest component of the sum of the absolute cross products. */
static int best_axis(double p[4][3])
{
    double size[3] = {0};
    for (int i = 0; i < 3; i++)
        for (int j = i + 1; j < 3; j++)
            for (int k = 0; k < 3; k++) {
                const int x = (k + 1) % 3, y = (k + 2) % 3;
                size[k] += fabs((p[i + 1][x] - p[i][x]) * (p[j + 1][y] - p[j][y]) -
                                (p[i + 1][y] - p[i][y]) * (p[j + 1][x] - p[j][x]));
            }
    return size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
}

/* ---- the whole ---- */

static double power_of_two_near(double largest)
{
    int exponent = 0;
    frexp(largest, &exponent);
    return ldexp(1, -bat_max_int(exponent, -1000));
}

static batten_vec3 point_at(int d, const double *points, double t)
{
    double row[3] = {0};
    const double s = 1 - t, b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < d; k++)
            row[k] += b[i] * points[i * d + k];
    return bat_vec3_of(3, row);
}

/* A line along the third axis is a point when that is left out: leave another out then. */
static int axis_to_drop(int dimension, double p[4][3])
{
    const int axis = dimension == 2 ? 2 : best_axis(p);
    double spread[3] = {0};
    for (int i = 1; i < 4; i++)
        for (int k = 0; k < 3; k++)
            spread[k] = bat_max(spread[k], fabs(p[i][k] - p[0][k]));
    if (spread[(axis + 1) % 3] == 0 && spread[(axis + 2) % 3] == 0)
        return (axis + 1) % 3;
    return axis;
}

static batten_status classify(int dimension, const double *points, double tolerance,
                              batten_cubic *out)
{
    double scaled[4][3] = {{0}};
    bat_cubic c;
    batten_cubic found = blank();
    const double largest = bat_largest(4 * dimension, points);
    c.scale = largest > 0 ? power_of_two_near(largest) : 1;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < dimension; k++)
            scaled[i][k] = points[i * dimension + k] * c.scale;
    if (dimension == 3 && bat_cubic_has_volume(scaled, tolerance, &found.margin)) {
        found.segment = found.whole = BATTEN_CUBIC_SPACE;
        found.whole_margin = found.flatness = found.margin;
        *out = found;
        return BATTEN_OK;
    }
    const int axis = axis_to_drop(dimension, scaled), x = axis == 0, y = axis == 2 ? 1 : 2;
    for (int i = 0; i < 4; i++) {
        c.point[i][0] = scaled[i][x];
        c.point[i][1] = scaled[i][y];
    }
    found.margin = 0;
    look_at_plane(&c, tolerance, &found);
    if (found.whole == BATTEN_CUBIC_LOOP)
        found.double_point = point_at(dimension, points, found.crossing[0]);
    if (!isfinite(found.p) || !isfinite(found.q) || !isfinite(found.r))
        return bat_fail(BATTEN_OVERFLOW, "the products of edges up to %g leave the numbers",
                        c.longest / c.scale);
    *out = found;
    return BATTEN_OK;
}

static batten_status check_arguments(int dimension, double tolerance)
{
    if (dimension != 2 && dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "cubics are classified in 2 or 3 dimensions, not %d", dimension);
    if (!(tolerance >= 0 && tolerance < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance %g is not in [0, 1)", tolerance);
    return BATTEN_OK;
}

typedef struct {
    int dimension;
    const double *points;
    double tolerance;
    batten_cubic *out;
} batch;

static batten_status classify_chunk(void *context, size_t begin, size_t end)
{
    const batch *b = context;
    const size_t width = 4 * (size_t)b->dimension;
    for (size_t i = begin; i < end; i++) {
        const double *points = b->points + width * i;
        const size_t bad = bat_first_not_finite(points, width);
        if (bad < width)
            return bat_fail(BATTEN_NOT_FINITE, "point %d of cubic %zu is not finite",
                            (int)bad / b->dimension + 1, i + 1);
        const batten_status status = classify(b->dimension, points, b->tolerance, &b->out[i]);
        if (status != BATTEN_OK)
            return bat_fail(status, "cubic %zu: %s", i + 1, batten_message());
    }
    return BATTEN_OK;
}

batten_status batten_cubics_classify(size_t count, int dimension, const double *points,
                                     double tolerance, const batten_job *job, batten_cubic *out)
{
    enum { CHUNK = 4096 };
    batch b = {dimension, points, tolerance, out};
    const batten_status status = check_arguments(dimension, tolerance);
    return status == BATTEN_OK ? bat_parallel(job, count, CHUNK, classify_chunk, &b) : status;
}

batten_status batten_cubic_classify(int dimension, const double *points, double tolerance,
                                    batten_cubic *out)
{
    batten_status status = check_arguments(dimension, tolerance);
    if (status != BATTEN_OK)
        return status;
    const size_t bad = bat_first_not_finite(points, 4 * (size_t)dimension);
    if (bad < 4 * (size_t)dimension)
        return bat_fail(BATTEN_NOT_FINITE, "point %d is not finite", (int)bad / dimension + 1);
    return classify(dimension, points, tolerance, out);
}

/* ---- spans of a curve ---- */

static void shift_parameters(batten_cubic *cubic, double a, double b)
{
    for (int k = 0; k < 2; k++) {
        cubic->inflections[k] = a + (b - a) * cubic->inflections[k];
        cubic->crossing[k] = a + (b - a) * cubic->crossing[k];
    }
    cubic->cusp = a + (b - a) * cubic->cusp;
    cubic->from = a;
    cubic->to = b;
}

static batten_status classify_spans(const batten_curve *bezier, double tolerance, int count,
                                    batten_cubic *out)
{
    const int d = batten_curve_dimension(bezier);
    double *breaks = bat_array((size_t)batten_curve_point_count(bezier) + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    batten_curve_spans(bezier, breaks);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        status = batten_cubic_classify(d, batten_curve_points(bezier) + 3 * i * d, tolerance,
                                       &out[i]);
        if (status == BATTEN_OK)
            shift_parameters(&out[i], breaks[i], breaks[i + 1]);
    }
    bat_release(breaks);
    return status;
}

void batten_cubics_release(batten_cubics *cubics)
{
    bat_release(cubics->at);
    *cubics = (batten_cubics){0, NULL};
}

batten_status batten_curve_classify(const batten_curve *curve, double tolerance,
                                    batten_cubics *out)
{
    const int degree = batten_curve_degree(curve);
    batten_curve *cubic = NULL, *bezier = NULL;
    if (batten_curve_is_rational(curve))
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "spans are classified of polynomial curves, and this one is rational, as circles "
            "and conics are");
    if (degree > 3)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "cubic spans are of degree 3 at most, not of degree %d", degree);
    batten_status status = check_arguments(batten_curve_dimension(curve), tolerance);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(curve, 3 - degree, &cubic);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(cubic, &bezier);
    const int spans = status == BATTEN_OK ? batten_curve_spans(bezier, NULL) - 1 : 0;
    batten_cubic *found = NULL;
    if (status == BATTEN_OK && !(found = bat_array((size_t)spans, sizeof *found)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = classify_spans(bezier, tolerance, spans, found);
    batten_curve_unref(bezier);
    batten_curve_unref(cubic);
    if (status != BATTEN_OK) {
        bat_release(found);
        return status;
    }
    *out = (batten_cubics){spans, found};
    return BATTEN_OK;
}
