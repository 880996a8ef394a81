/* What is known and what is free along the sides and spokes of a hole. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <string.h>

/* ---- vectors and numbers that are linear in the unknowns ---- */

static void add_multiple(size_t length, double *out, double factor, const double *in)
{
    for (size_t k = 0; k < length; k++)
        out[k] += factor * in[k];
}

static void add_vector(const bat_fill *fill, double *out, double factor, const double *in)
{
    add_multiple(bat_fill_length(fill), out, factor, in);
}

/* A fixed part of a vector. */
static void add_fixed(const bat_fill *fill, double *out, double factor, const double value[3])
{
    add_multiple(3, out + bat_fill_length(fill) - 3, factor, value);
}

/* number times a fixed vector */
static void add_times(const bat_fill *fill, double *out, const double *number,
                      const double vector[3])
{
    for (int k = 0; k <= fill->unknowns; k++)
        add_multiple(3, out + (size_t)3 * (size_t)k, number[k], vector);
}

static void add_half(const bat_fill *fill, double *out, const double *number,
                     const double vector[3])
{
    const double half[3] = {vector[0] / 2, vector[1] / 2, vector[2] / 2};
    add_times(fill, out, number, half);
}

static void new_vector(double *out, int *next)
{
    for (int c = 0; c < 3; c++)
        out[3 * (*next + c) + c] = 1;
    *next += 3;
}

static void new_along(double *out, const double direction[3], int *next)
{
    add_multiple(3, out + (size_t)3 * (size_t)*next, 1, direction);
    *next += 1;
}

/* number = vector . fixed */
static void component(const bat_fill *fill, const double *vector, const double fixed[3],
                      double *number)
{
    for (int k = 0; k <= fill->unknowns; k++)
        number[k] = bat_dot(3, vector + (size_t)3 * (size_t)k, fixed);
}

void bat_fill_vector(const bat_fill *fill, const double *vector, double out[3])
{
    const int n = fill->unknowns;
    for (int c = 0; c < 3; c++)
        out[c] = vector[3 * n + c];
    for (int k = 0; k < n; k++)
        add_multiple(3, out, fill->x[k], vector + (size_t)3 * (size_t)k);
}

double bat_fill_number(const bat_fill *fill, const double *number)
{
    return number[fill->unknowns] + bat_dot(fill->unknowns, fill->x, number);
}

/* ---- corners ---- */

/* A corner seen from one of its sides. */
typedef struct {
    bat_fill_fields *side;
    int station;
    bat_fill_seen seen;
} corner_side;

/* a and b, a' and b' of a side with a slope in a corner where D' is `turn`. */
static void set_factors(const bat_fill *fill, const corner_side *c, const double *turn)
{
    const bat_fill_place *p = &c->side->place[c->station];
    double *(*factor)[2] = c->side->factor[c->station];
    factor[0][0][fill->unknowns] = c->seen.a;
    factor[1][0][fill->unknowns] = c->seen.b;
    component(fill, turn, c->seen.to_a, factor[0][1]);
    component(fill, turn, c->seen.to_b, factor[1][1]);
    for (int k = 0; k < 2; k++) {
        const double *dual = k == 0 ? c->seen.to_a : c->seen.to_b;
        factor[k][1][fill->unknowns] -= c->seen.a * bat_dot(3, p->slope[1], dual) +
                                        c->seen.b * bat_dot(3, p->curve[2], dual);
    }
}

/* D' in a corner, one or both of whose sides have a slope: two unknowns in the mean of their
 * tangent planes, and the mean of what they say about how the plane turns. */
static void set_turn(const bat_fill *fill, const corner_side c[2], double *turn, int *next)
{
    double normal[3] = {0}, along[3], across[3], twist = 0;
    const double *C = NULL;
    for (int k = 1; k >= 0; k--)
        if (c[k].side->has_slope) {
            add_multiple(3, normal, 1, c[k].seen.normal);
            C = c[k].side->place[c[k].station].curve[1];
            /* Seen from the side before, D' has the other sign. */
            twist += k == 0 ? c[k].seen.twist : -c[k].seen.twist;
        }
    if (c[0].side->has_slope && c[1].side->has_slope)
        twist /= 2;
    if (!(bat_norm(3, normal) > BAT_MEANT_SAME)) /* opposite planes have no mean */
        memcpy(normal, c[0].seen.normal, sizeof normal);
    const double size = bat_norm(3, normal);
    for (int m = 0; m < 3; m++)
        normal[m] /= size;
    bat_cross(normal, C, across);
    bat_cross(across, normal, along);
    const double speed = bat_norm(3, along);
    for (int m = 0; m < 3; m++) {
        along[m] /= speed;
        across[m] /= speed;
    }
    new_along(turn, along, next);
    c[0].side->corner_turn = *next;
    new_along(turn, across, next);
    add_fixed(fill, turn, twist, normal);
}

/* The corner at the start of side i: the derivatives across both sides are those of the other
 * one, and their derivatives are one vector, the twist. */
static batten_status set_corner(bat_fill *fill, int i, int *next)
{
    const int before = (i + fill->count - 1) % fill->count;
    corner_side c[2] = {{.side = &fill->side[i], .station = FILL_START},
                        {.side = &fill->side[before], .station = FILL_END}};
    const bat_fill_place *places[2] = {&c[0].side->place[FILL_START],
                                       &c[1].side->place[FILL_END]};
    for (int k = 0; k < 2; k++) {
        double across[3];
        bat_fill_across(k, places[1 - k], across);
        add_fixed(fill, c[k].side->across[c[k].station][0], 1, across);
        const int given = fill->loop->sides[k == 0 ? i : before].given;
        const batten_status status =
            c[k].side->has_slope
                ? bat_fill_look(places[k], c[k].station, across, given, &c[k].seen)
                : BATTEN_OK;
        if (status != BATTEN_OK)
            return status;
    }
    double *turn = c[0].side->across[FILL_START][1];
    c[0].side->corner_turn = -1;
    c[0].side->flat_corner = bat_fill_is_flat(places[0], places[1]);
    if (c[0].side->has_slope || c[1].side->has_slope)
        set_turn(fill, c, turn, next);
    else
        new_vector(turn, next);
    add_vector(fill, c[1].side->across[FILL_END][1], -1, turn);
    for (int k = 0; k < 2; k++)
        if (c[k].side->has_slope)
            set_factors(fill, &c[k], c[k].side->across[c[k].station][1]);
    return BATTEN_OK;
}

/* ---- middles, spokes, centre ---- */

/* W' = D' at the middle, but for what c t G' adds to it on both sides of the spoke, see
 * set_centre. A knot of the side there: halfway between what is before and behind. */
static void set_middle(const bat_fill *fill, bat_fill_fields *side, int *next)
{
    double *turn = side->turn[0][1];
    side->middle_speed = side->has_slope ? *next : -1;
    if (!side->has_slope) {
        new_vector(side->across[FILL_BEFORE][0], next);
        new_vector(turn, next);
        memcpy(side->across[FILL_AFTER][0], side->across[FILL_BEFORE][0],
               bat_fill_length(fill) * sizeof *turn);
    }
    for (int h = 0; h < 2; h++) {
        const int station = h == 0 ? FILL_BEFORE : FILL_AFTER;
        const bat_fill_place *p = &side->place[station];
        double *(*factor)[2] = side->factor[station];
        for (int k = 0; k < 2 && side->has_slope; k++) {
            factor[k][0][*next + 2 * k] = 1;
            factor[k][1][*next + 2 * k + 1] = 1;
            const double *vector = k == 0 ? p->slope[0] : p->curve[1];
            add_times(fill, side->across[station][0], factor[k][0], vector);
            add_half(fill, turn, factor[k][1], vector);
            add_half(fill, turn, factor[k][0], k == 0 ? p->slope[1] : p->curve[2]);
        }
    }
    *next += side->has_slope ? 4 : 0;
    for (int h = 0; h < 2; h++) {
        const int station = h == 0 ? FILL_BEFORE : FILL_AFTER;
        const double c = h == 0 ? fill->cosine : -fill->cosine;
        add_vector(fill, side->across[station][1], 1, turn);
        add_vector(fill, side->across[station][1], c, side->across[station][0]);
        for (int k = 0; k < 2; k++)
            add_multiple((size_t)fill->unknowns + 1, side->factor[station][k][1], c,
                         side->factor[station][k][0]);
    }
}

/* cos(2 pi i / n) E1 + sin(2 pi i / n) E2 for unknowns 3 .. 8. */
static void add_ray(const bat_fill *fill, double *out, double factor, int i)
{
    const double angle = 2 * BAT_PI * i / fill->count;
    for (int c = 0; c < 3; c++) {
        out[3 * (3 + c) + c] += factor * bat_cos(angle);
        out[3 * (6 + c) + c] += factor * bat_sin(angle);
    }
}

static void set_spoke(bat_fill *fill, int i, int *next)
{
    const int n = fill->count;
    bat_fill_fields *side = &fill->side[i];
    const bat_fill_place *p = &side->place[FILL_BEFORE];
    int first = 0;
    add_fixed(fill, side->spoke[0][0], 1, p->curve[0]);
    add_vector(fill, side->spoke[0][1], 1, side->across[FILL_BEFORE][0]);
    new_vector(side->spoke[0][2], next);
    new_vector(side->spoke[1][0], &first); /* unknowns 0 .. 2 are the centre */
    add_ray(fill, side->spoke[1][1], 1, i);
    if (n % 2 == 1 || n == 4 || i < n - 1)
        new_vector(side->spoke[1][2], next);
    else /* the alternating sum vanishes, see set_centre */
        for (int k = 0; k < n - 1; k++)
            add_vector(fill, side->spoke[1][2], k % 2 == 0 ? 1 : -1, fill->side[k].spoke[1][2]);
    add_fixed(fill, side->turn[0][0], 1, p->curve[1]);
    add_ray(fill, side->turn[1][0], 0.5, i - 1 + n);
    add_ray(fill, side->turn[1][0], -0.5, i + 1);
}

/* R of spoke i, the sum of W' of it and the spoke before: what the twist of quad i asks for. */
static void add_demand(const bat_fill *fill, double *out, double factor, int i)
{
    const int n = fill->count, before = (i + n - 1) % n;
    const double c = fill->cosine;
    add_ray(fill, out, c * factor, before);
    add_ray(fill, out, -c * factor, i);
    add_vector(fill, out, c * factor, fill->side[before].spoke[1][2]);
    add_vector(fill, out, -c * factor, fill->side[i].spoke[1][2]);
}

/*
 * Both neighbours of spoke i have S_v = G', and S_u = W + l G' and -W + l G' with l = c t, c =
 * cos(2 pi / n), since e(i - 1) + e(i + 1) = 2 c e(i) in the centre. So it is in a regular
 * polygon too. A quad has one twist in the centre, whether it is seen from spoke i or i - 1:
 * W'(i) + W'(i - 1) = c (e(i - 1) - e(i)) + c (G''(i - 1) - G''(i)).  Round the centre that is
 * solvable for odd n; for even n when the alternating sum of c G'' vanishes, and then one W' is
 * free.
 */
static void set_centre(bat_fill *fill, int *next)
{
    const int n = fill->count;
    for (int i = 0; i < n; i++) {
        double *turn = fill->side[i].turn[1][1];
        if (n % 2 == 1) {
            for (int k = 0; k < n; k++)
                add_demand(fill, turn, k % 2 == 0 ? 0.5 : -0.5, (i + n - k) % n);
        } else if (i == 0) {
            new_vector(turn, next);
        } else {
            add_demand(fill, turn, 1, i);
            add_vector(fill, turn, -1, fill->side[i - 1].turn[1][1]);
        }
    }
}

/* ---- the whole ---- */

static batten_status look_at_side(const bat_fill_side *side, bat_fill_fields *out)
{
    batten_status status = BATTEN_OK;
    out->has_slope = side->slope != NULL;
    for (int station = 0; status == BATTEN_OK && station < FILL_STATIONS; station++)
        status = bat_fill_see_place(side, station, &out->place[station]);
    return status;
}

static int count_unknowns(const bat_fill *fill)
{
    const int n = fill->count;
    int count = 9 + (n % 2 == 0 ? 3 : 0) - (n % 2 == 0 && n != 4 ? 3 : 0);
    for (int i = 0; i < n; i++) {
        const bool slope = fill->side[i].has_slope;
        const bool before = fill->side[(i + n - 1) % n].has_slope;
        count += 6 + (slope ? 4 : 6) + (slope || before ? 2 : 3);
    }
    return count;
}

static double *take_numbers(double **memory, size_t count)
{
    double *at = *memory;
    *memory += count;
    return at;
}

/* 18 vectors and 16 numbers for each side, all 0. */
static batten_status lay_out(bat_fill *fill)
{
    const size_t numbers = (size_t)fill->unknowns + 1, vectors = 3 * numbers;
    fill->x = bat_array((size_t)fill->unknowns, sizeof *fill->x);
    fill->memory =
        bat_array((size_t)fill->count * (18 * vectors + 16 * numbers), sizeof *fill->memory);
    if (!fill->memory || !fill->x)
        return BATTEN_OUT_OF_MEMORY;
    double *memory = fill->memory;
    for (int i = 0; i < fill->count; i++) {
        bat_fill_fields *side = &fill->side[i];
        for (int station = 0; station < FILL_STATIONS; station++)
            for (int order = 0; order < 2; order++) {
                side->across[station][order] = take_numbers(&memory, vectors);
                side->factor[station][0][order] = take_numbers(&memory, numbers);
                side->factor[station][1][order] = take_numbers(&memory, numbers);
            }
        for (int end = 0; end < 2; end++)
            for (int order = 0; order < 3; order++) {
                side->spoke[end][order] = take_numbers(&memory, vectors);
                if (order < 2)
                    side->turn[end][order] = take_numbers(&memory, vectors);
            }
    }
    return BATTEN_OK;
}

batten_status bat_fill_make(const bat_fill_loop *loop, batten_surface *const *plane,
                            bat_fill *fill)
{
    batten_status status = BATTEN_OK;
    fill->loop = loop;
    fill->count = loop->count;
    fill->cosine = loop->count == 4 ? 0 : bat_cos(2 * BAT_PI / loop->count);
    for (int i = 0; status == BATTEN_OK && i < fill->count; i++)
        status = look_at_side(&loop->sides[i], &fill->side[i]);
    if (status == BATTEN_OK) {
        fill->unknowns = count_unknowns(fill);
        status = lay_out(fill);
    }
    int next = 9;
    for (int i = 0; status == BATTEN_OK && i < fill->count; i++)
        status = set_corner(fill, i, &next);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < fill->count; i++)
        set_middle(fill, &fill->side[i], &next);
    for (int i = 0; i < fill->count; i++)
        set_spoke(fill, i, &next);
    set_centre(fill, &next);
    assert(next == fill->unknowns);
    return bat_fill_relax(fill, plane);
}

void bat_fill_end(bat_fill *fill)
{
    bat_release(fill->memory);
    bat_release(fill->x);
}
