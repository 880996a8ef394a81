/* Curves given by expressions of a parameter: quintic pieces whose error intervals prove. */
#include "base/list.h"
#include "base/work.h"
#include "shape/equation/pieces.h"
#include "shape/equation/program.h"

/* The remainder needs the sixth derivative. */
#define ORDER 6
#define MOST_PIECES 20000

typedef struct {
    int dimension;
    const batten_equation *const *coordinates;
    batten_interval range;
    double tolerance;
    bat_jet_space space;
    bat_quintic_piece *pieces;
    int count, room;
    double error;
    bat_interval_jet over[3], first[3], last[3]; /* of the interval, its ends */
    bat_definition state;
    batten_equation_curves made;
    bat_work work;
} tracer;

/* ---- one interval ---- */

static bat_definition evaluate(tracer *t, bat_interval range, int side, bat_interval_jet *out)
{
    bat_interval_jet parameter;
    bat_definition worst = BAT_DEFINED;
    t->space.side = side;
    bat_ijet_variable(&t->space, 0, range, &parameter);
    for (int k = 0; k < t->dimension; k++) {
        bat_equation_jet(t->coordinates[k], &t->space, &parameter, &out[k]);
        worst = t->space.state > worst ? t->space.state : worst;
    }
    return worst;
}

/* |H| <= 1, 0.22 h, 0.016 h^2: what quintic Hermite functions make of values, first and second derivatives
 * that are wrong. The second one stands halved in the jet. */
static double error_of_ends(const bat_interval_jet *a, double h)
{
    return bat_interval_width(a->c[0]) + 0.22 * h * bat_interval_width(a->c[1]) +
           0.032 * h * h * bat_interval_width(a->c[2]);
}

/* How far a quintic is from the curve: f^(6) / 6! (t - a)^3 (t - b)^3, and what rounding does.
 * NaN or infinity where a derivative is not known. */
static double error_of_quintic(const tracer *t, double h)
{
    double sum = 0, size = 0;
    for (int k = 0; k < t->dimension; k++) {
        const double remainder =
            bat_interval_size(t->over[k].c[ORDER]) * bat_pow(0.5 * h, ORDER);
        const double all =
            remainder + error_of_ends(&t->first[k], h) + error_of_ends(&t->last[k], h);
        sum += all * all;
        size = bat_max(size, bat_interval_size(t->over[k].c[0]));
    }
    /* de Casteljau: five levels, each of which rounds three times. */
    return sqrt(sum) + 3 * BAT_QUINTIC * DBL_EPSILON * size;
}

/* Of any line through two points of the curve: the extent of the curve there. */
static double error_of_chord(const tracer *t)
{
    double sum = 0;
    for (int k = 0; k < t->dimension; k++) {
        const bat_interval all = bat_interval_hull(
            t->over[k].c[0], bat_interval_hull(t->first[k].c[0], t->last[k].c[0]));
        sum += bat_interval_width(all) * bat_interval_width(all);
    }
    return sqrt(sum);
}

static bool have_values(const bat_interval_jet *at, int dimension)
{
    for (int k = 0; k < dimension; k++)
        if (!bat_interval_is_finite(at[k].c[0]))
            return false;
    return true;
}

/* ---- pieces ---- */

static void fill_quintic(const tracer *t, bat_quintic_piece *p)
{
    const double h = p->b - p->a;
    for (int k = 0; k < t->dimension; k++) {
        double l[3], r[3];
        for (int i = 0; i < 3; i++) {
            l[i] = bat_interval_middle(t->first[k].c[i]);
            r[i] = bat_interval_middle(t->last[k].c[i]);
        }
        p->leg[0][k] = l[0];
        p->leg[1][k] = l[0] + h / 5 * l[1];
        p->leg[2][k] = l[0] + 2 * h / 5 * l[1] + h * h / 10 * l[2];
        p->leg[3][k] = r[0] - 2 * h / 5 * r[1] + h * h / 10 * r[2];
        p->leg[4][k] = r[0] - h / 5 * r[1];
        p->leg[5][k] = r[0];
    }
}

static void fill_chord(const tracer *t, bat_quintic_piece *p)
{
    p->is_chord = true;
    for (int i = 0; i <= BAT_QUINTIC; i++)
        for (int k = 0; k < t->dimension; k++) {
            const double l = bat_interval_middle(t->first[k].c[0]);
            const double r = bat_interval_middle(t->last[k].c[0]);
            p->leg[i][k] = l + i * (r - l) / BAT_QUINTIC;
        }
}

static batten_status add_piece(tracer *t, double a, double b, bool is_chord, double error)
{
    bat_quintic_piece piece = {.a = a, .b = b};
    if (t->count == MOST_PIECES)
        return bat_fail(BATTEN_TOO_LARGE,
                        "more than %d pieces; %g is too fine, or the curve winds too often",
                        MOST_PIECES, t->tolerance);
    if (is_chord)
        fill_chord(t, &piece);
    else
        fill_quintic(t, &piece);
    /* The end of the last piece, to the bit. */
    for (int k = 0; k < t->dimension && t->count > 0; k++)
        piece.leg[0][k] = t->pieces[t->count - 1].leg[BAT_QUINTIC][k];
    t->error = bat_max(t->error, error);
    return BAT_LIST_ADD(t->pieces, t->count, t->room, piece);
}

static batten_status no_value(const tracer *t, double a, double b)
{
    if (t->state == BAT_UNDEFINED)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "there is no value between %.10g and %.10g; take a range without it", a,
                        b);
    return bat_fail(BATTEN_OUT_OF_DOMAIN,
                    "no finite value, or a jump, at %.10g; take ranges that end before it",
                    0.5 * a + 0.5 * b);
}

/* Evaluate over [a, b] and at its ends; is there a quintic or a chord within the tolerance? */
static batten_status try_interval(tracer *t, double a, double b, bool *done)
{
    *done = false;
    t->state = evaluate(t, (bat_interval){a, b}, 0, t->over);
    if (t->state == BAT_UNDEFINED)
        return no_value(t, a, b);
    const bat_definition left = evaluate(t, bat_interval_at(a), 1, t->first);
    const bat_definition right = evaluate(t, bat_interval_at(b), -1, t->last);
    if (left == BAT_UNDEFINED || right == BAT_UNDEFINED) {
        const double at = left == BAT_UNDEFINED ? a : b;
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "there is no finite value at %.10g; take ranges that end before it",
                        at);
    }
    const double error = error_of_quintic(t, b - a), chord = error_of_chord(t);
    if (t->state == BAT_DEFINED && error <= t->tolerance)
        *done = true;
    else if (!isfinite(error) && chord <= t->tolerance && have_values(t->first, t->dimension) &&
             have_values(t->last, t->dimension))
        *done = true;
    if (!*done)
        return BATTEN_OK;
    const bool is_chord = !(error <= t->tolerance);
    return add_piece(t, a, b, is_chord, is_chord ? chord : error);
}

/* An interval of which nothing can be shown any more: too short, or as accurate as rounding allows. */
static batten_status check_interval(const tracer *t, double a, double b)
{
    const double middle = 0.5 * a + 0.5 * b;
    if (!(middle > a && middle < b))
        return no_value(t, a, b);
    double rounding = 0;
    for (int k = 0; k < t->dimension; k++) {
        const double evaluated = 3 * BAT_QUINTIC * DBL_EPSILON * fabs(t->first[k].c[0].lo);
        rounding = bat_max(rounding, bat_max(evaluated, bat_interval_width(t->first[k].c[0])));
    }
    if (t->state == BAT_DEFINED && isfinite(rounding) && rounding > t->tolerance)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "at %.10g rounding leaves %.3g in doubt, more than the tolerance, %.3g",
                        a, rounding, t->tolerance);
    return BATTEN_OK;
}

/* From left to right; what waits has ends that fall. */
static batten_status divide_range(tracer *t)
{
    /* Each halving adds one end; a tenth root at 0 takes 200 to come below 1e-6. */
    enum { MOST_HALVINGS = 255 };
    double ends[MOST_HALVINGS + 1];
    int waiting = 1;
    double a = t->range.a;
    ends[0] = t->range.b;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && waiting > 0) {
        bool done = false;
        const double b = ends[waiting - 1];
        status = try_interval(t, a, b, &done);
        t->made.boxes++;
        if (status == BATTEN_OK && !done)
            status = waiting > MOST_HALVINGS ? no_value(t, a, b) : check_interval(t, a, b);
        if (status == BATTEN_OK && !done)
            ends[waiting++] = 0.5 * a + 0.5 * b;
        if (status == BATTEN_OK && done) {
            a = b;
            waiting--;
        }
        if (status == BATTEN_OK)
            status = bat_work_step(&t->work, 1, (a - t->range.a) / (t->range.b - t->range.a),
                                   "curve of equations");
    }
    return status;
}

/* ---- what is special ---- */

static batten_status add_special(tracer *t, batten_equation_point_kind kind, double at)
{
    bat_interval_jet value[3];
    double p[3] = {0, 0, 0};
    evaluate(t, bat_interval_at(at), 1, value);
    for (int k = 0; k < t->dimension; k++)
        p[k] = bat_interval_middle(value[k].c[0]);
    return bat_equation_add_point(&t->made,
                                  (batten_equation_point){kind, {p[0], p[1], p[2]}, at, 0});
}

static bool is_smooth(tracer *t, double a, double b)
{
    evaluate(t, (bat_interval){a, b}, 0, t->over);
    for (int k = 0; k < t->dimension; k++)
        if (!bat_interval_is_finite(t->over[k].c[2]))
            return false;
    return true;
}

/* Where in [a, b] the second derivative fails, by halving. */
static double place_of_corner(tracer *t, double a, double b)
{
    enum { MOST = 100 };
    for (int i = 0; i < MOST; i++) {
        const double middle = 0.5 * a + 0.5 * b;
        const bool left = is_smooth(t, a, middle), right = is_smooth(t, middle, b);
        if (!(middle > a && middle < b) || (!left && !right))
            break;
        if (left && right)
            return middle;
        if (left)
            a = middle;
        else
            b = middle;
    }
    /* The end of the range, where it is one. */
    return a == t->range.a ? a : b == t->range.b ? b : 0.5 * a + 0.5 * b;
}

/* A run of chords is one place; so is a joint where the derivatives jump. */
static batten_status find_corners(tracer *t)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        int end = i;
        while (end < t->count && t->pieces[end].is_chord)
            end++;
        if (end > i)
            status = add_special(t, BATTEN_EQUATION_CORNER,
                                 place_of_corner(t, t->pieces[i].a, t->pieces[end - 1].b));
        else if (i > 0 && !t->pieces[i - 1].is_chord &&
                 !bat_quintics_agree(t->dimension, &t->pieces[i - 1], &t->pieces[i]))
            status = add_special(t, BATTEN_EQUATION_CORNER, t->pieces[i].a);
        i = end > i ? end - 1 : i;
    }
    return status;
}

static bool may_stand(tracer *t, double a, double b)
{
    evaluate(t, (bat_interval){a, b}, 0, t->over);
    for (int k = 0; k < t->dimension; k++)
        if (!bat_interval_holds_zero(t->over[k].c[1]))
            return false;
    return true;
}

/* Where all first derivatives can vanish, to a millionth of a piece; neighbours are one. */
static batten_status find_halts_of(tracer *t, const bat_quintic_piece *p, double *last)
{
    enum { HALVINGS = 20, MOST = 64 };
    struct {
        double a, b;
        int depth;
    } waiting[MOST] = {{p->a, p->b, 0}};
    int count = 1;
    batten_status status = BATTEN_OK;
    const double near = 4 * ldexp(p->b - p->a, -HALVINGS);
    while (count > 0 && status == BATTEN_OK) {
        const double a = waiting[count - 1].a, b = waiting[count - 1].b;
        const int depth = waiting[--count].depth;
        if (!may_stand(t, a, b))
            continue;
        const double middle = 0.5 * a + 0.5 * b;
        if (depth < HALVINGS) {
            waiting[count].a = middle, waiting[count].b = b, waiting[count++].depth = depth + 1;
            waiting[count].a = a, waiting[count].b = middle, waiting[count++].depth = depth + 1;
        } else {
            if (!(middle - *last <= near))
                status = add_special(t, BATTEN_EQUATION_HALT, middle);
            *last = b;
        }
    }
    return status;
}

static batten_status find_halts(tracer *t)
{
    batten_status status = BATTEN_OK;
    double last = -INFINITY;
    for (int i = 0; i < t->count && status == BATTEN_OK; i++)
        if (!t->pieces[i].is_chord)
            status = find_halts_of(t, &t->pieces[i], &last);
    return status;
}

/* ---- the whole ---- */

static batten_status check_parametric(int dimension, const batten_equation *const *coordinates,
                                      batten_interval range, double tolerance)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d coordinates; a curve has 1 to 3", dimension);
    for (int k = 0; k < dimension; k++)
        if (coordinates[k]->variable_count != 1)
            return bat_fail(BATTEN_BAD_ARGUMENT, "coordinate %d has %d variables, expected 1",
                            k + 1, coordinates[k]->variable_count);
    if (!isfinite(range.a) || !isfinite(range.b) || !isfinite(tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the range or the tolerance is not finite");
    if (!(range.a < range.b))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the range from %g to %g is empty", range.a,
                        range.b);
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance must be above 0, not %g",
                        tolerance);
    return BATTEN_OK;
}

batten_status batten_curve_parametric(int dimension, const batten_equation *const *coordinates,
                                      batten_interval range, double tolerance,
                                      const batten_job *job, batten_equation_curves *out)
{
    batten_status status = check_parametric(dimension, coordinates, range, tolerance);
    if (status != BATTEN_OK)
        return status;
    tracer t = {.dimension = dimension,
                .coordinates = coordinates,
                .range = range,
                .tolerance = tolerance,
                .work = {.job = job}};
    batten_curve *curve = NULL;
    bat_jet_space_begin(&t.space, 1, ORDER);
    status = divide_range(&t);
    if (status == BATTEN_OK)
        status = find_corners(&t);
    if (status == BATTEN_OK)
        status = find_halts(&t);
    if (status == BATTEN_OK)
        status = bat_quintics_joined(dimension, t.count, t.pieces, &curve);
    if (status == BATTEN_OK) {
        status = bat_equation_add_curve(&t.made, curve);
        if (status != BATTEN_OK)
            batten_curve_unref(curve);
    }
    t.made.error = t.error;
    if (status == BATTEN_OK)
        *out = t.made;
    else
        batten_equation_curves_release(&t.made);
    bat_release(t.pieces);
    return status;
}
