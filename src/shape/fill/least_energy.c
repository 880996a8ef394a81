/*
 * What is free in a fill is chosen so that its curvature varies least: the integral of the
 * squares of the third derivatives over a polygon in the plane, and of the jumps of the second
 * derivatives between the quads. Both vanish for surfaces of degree two.
 */
#include "numeric/dense.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <string.h>

enum { PARTS = 3, NODES = 4, PLACES = PARTS * NODES, FIRST = PLACES, LAST, ALL_PLACES };
enum { DERIVATIVES = 9, ROWS = 7 }; /* up to third order; of second and third order */

typedef struct {
    const bat_fill *fill;
    batten_surface *const *plane;
    size_t length, step;                   /* of a vector; of one function with derivatives */
    double at[ALL_PLACES], weight[PLACES]; /* Gauss' places, and both ends */
    double *edges[2];       /* of one quad: [ALL_PLACES][4][FILL_ORDERS][length] */
    double *corner;         /* [4][4][length] */
    double *derivatives;    /* [DERIVATIVES][length]: S_u, S_v, S_uu ... */
    double *rows;           /* [ROWS][length] in the plane: S_xx, S_xy, S_yy ... */
    double *seams;          /* [n][2: u = 1, v = 1][PLACES][3][length]: second derivatives */
    double *matrix, *right; /* the normal equations */
    double *lu, *solution;  /* work */
    int *used, *pivots;     /* unknowns that a row touches */
} variation;

static void add_product(size_t length, double *out, double factor, const double *in)
{
    if (factor != 0)
        for (size_t k = 0; k < length; k++)
            out[k] += factor * in[k];
}

/* F0, F1, G0, G1 and their derivatives at t: out [FILL_ORDERS][4]. */
static void blends(double t, double out[FILL_ORDERS][4])
{
    static const int order[4] = {0, 3, 1, 4};
    double table[FILL_ORDERS][6];
    bat_fill_hermite(1, t, FILL_ORDERS - 1, table);
    for (int m = 0; m < FILL_ORDERS; m++)
        for (int f = 0; f < 4; f++)
            out[m][f] = table[m][order[f]];
}

static const double *edge(const variation *b, int direction, int place, int function, int order)
{
    /* functions as bat_fill_edges has them, in the order of the blends: c0, c1, r0, r1 */
    static const int which[4] = {0, 2, 1, 3};
    return b->edges[direction] + (size_t)(4 * place + which[function]) * b->step +
           (size_t)order * b->length;
}

static batten_status prepare_quad(variation *b, int quad)
{
    for (int direction = 0; direction < 2; direction++)
        for (int g = 0; g < ALL_PLACES; g++) {
            double *out = b->edges[direction] + (size_t)(4 * g) * b->step;
            const batten_status status =
                bat_fill_edges(b->fill, quad, direction, b->at[g], out);
            if (status != BATTEN_OK)
                return status;
        }
    /* Where ribbons contradict each other both directions have their own: then the mean. */
    memset(b->corner, 0, 16 * b->length * sizeof(double));
    for (int a = 0; a < 4; a++)
        for (int c = 0; c < 4; c++) {
            double *corner = b->corner + (size_t)(4 * a + c) * b->length;
            add_product(b->length, corner, 0.5, edge(b, 0, FIRST + a % 2, c, a / 2));
            add_product(b->length, corner, 0.5, edge(b, 1, FIRST + c % 2, a, c / 2));
        }
    return BATTEN_OK;
}

/* The boolean sum of Coons: its derivatives at one place. */
static void boolean_sum(variation *b, int gu, int gv)
{
    double A[FILL_ORDERS][4], B[FILL_ORDERS][4];
    blends(b->at[gu], A);
    blends(b->at[gv], B);
    memset(b->derivatives, 0, DERIVATIVES * b->length * sizeof(double));
    double *out = b->derivatives;
    for (int total = 1; total < FILL_ORDERS; total++)
        for (int mv = 0; mv <= total; mv++, out += b->length) {
            const int mu = total - mv;
            for (int f = 0; f < 4; f++) {
                add_product(b->length, out, B[mv][f], edge(b, 0, gu, f, mu));
                add_product(b->length, out, A[mu][f], edge(b, 1, gv, f, mv));
                for (int c = 0; c < 4; c++)
                    add_product(b->length, out, -A[mu][f] * B[mv][c],
                                b->corner + (size_t)(4 * f + c) * b->length);
            }
        }
}

/* ---- derivatives in the plane ---- */

/* The derivatives of S(F(u, v)), without S itself, are M times those of S in the plane, both in
 * the order x, y; xx, xy, yy; xxx, xxy, xyy, yyy. F [10][3] as batten_surface_evaluate. */
static void chain_rule(const double F[10][3], double M[DERIVATIVES][DERIVATIVES])
{
    /* the derivatives by which variables, 0: u, 1: v */
    static const int by[DERIVATIVES][3] = {{0},       {1},       {0, 0},    {0, 1},   {1, 1},
                                           {0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    static const int place1[2] = {1, 2}, place2[3] = {3, 4, 5};
    memset(M, 0, DERIVATIVES * DERIVATIVES * sizeof(double));
    for (int r = 0; r < DERIVATIVES; r++) {
        const int order = r < 2 ? 1 : r < 5 ? 2 : 3, *w = by[r];
        for (int x = 0; x < 2; x++)
            M[r][x] += F[r + 1][x];
        if (order == 1)
            continue;
        for (int x = 0; x < 2; x++)
            for (int y = 0; y < 2; y++) {
                if (order == 2) {
                    M[r][2 + x + y] += F[place1[w[0]]][x] * F[place1[w[1]]][y];
                    continue;
                }
                for (int k = 0; k < 3; k++) /* one variable beside the other two */
                    M[r][2 + x + y] +=
                        F[place1[w[k]]][x] * F[place2[w[(k + 1) % 3] + w[(k + 2) % 3]]][y];
                for (int z = 0; z < 2; z++)
                    M[r][5 + x + y + z] +=
                        F[place1[w[0]]][x] * F[place1[w[1]]][y] * F[place1[w[2]]][z];
            }
    }
}

/* Rows of the second and third derivatives in the plane; *area is that of the map. */
static batten_status to_plane(variation *b, int quad, int gu, int gv, double *area)
{
    double F[10][3], M[DERIVATIVES][DERIVATIVES], inverse[DERIVATIVES][DERIVATIVES] = {{0}};
    int pivots[DERIVATIVES];
    batten_status status =
        batten_surface_evaluate(b->plane[quad], b->at[gu], b->at[gv], 3, F[0]);
    if (status != BATTEN_OK)
        return status;
    *area = F[1][0] * F[2][1] - F[1][1] * F[2][0];
    chain_rule((const double(*)[3])F, M);
    for (int k = 0; k < DERIVATIVES; k++)
        inverse[k][k] = 1;
    status = bat_dense_factor(DERIVATIVES, M[0], pivots);
    if (status != BATTEN_OK)
        return status;
    bat_dense_solve(DERIVATIVES, M[0], pivots, DERIVATIVES, inverse[0]);
    memset(b->rows, 0, ROWS * b->length * sizeof(double));
    for (int r = 0; r < ROWS; r++)
        for (int k = 0; k < DERIVATIVES; k++)
            add_product(b->length, b->rows + (size_t)r * b->length, inverse[r + 2][k],
                        b->derivatives + (size_t)k * b->length);
    return BATTEN_OK;
}

/* ---- the normal equations ---- */

/* weight |row . (x, 1)|^2 for the three coordinates of a row. */
static void accumulate(variation *b, const double *row, double weight)
{
    const int n = b->fill->unknowns;
    for (int c = 0; c < 3; c++) {
        const double *d = row + c;
        int count = 0;
        for (int k = 0; k < n; k++)
            if (d[3 * k] != 0)
                b->used[count++] = k;
        for (int i = 0; i < count; i++) {
            const double value = weight * d[3 * b->used[i]];
            double *to = b->matrix + (size_t)b->used[i] * (size_t)n;
            for (int j = 0; j <= i; j++)
                to[b->used[j]] += value * d[3 * b->used[j]];
            b->right[b->used[i]] -= value * d[3 * n];
        }
    }
}

static double *seam(const variation *b, int quad, int which, int place)
{
    return b->seams + (size_t)(3 * (PLACES * (2 * quad + which) + place)) * b->length;
}

/* Of terms that stand for more than one derivative: S_xy; S_xxy, S_xyy. */
static const double times[ROWS] = {1, 2, 1, 1, 3, 3, 1};

static batten_status sum_quad(variation *b, int quad)
{
    batten_status status = prepare_quad(b, quad);
    for (int gu = 0; gu < PLACES; gu++)
        for (int gv = 0; status == BATTEN_OK && gv < PLACES; gv++) {
            double area = 0;
            boolean_sum(b, gu, gv);
            status = to_plane(b, quad, gu, gv, &area);
            for (int r = 3; status == BATTEN_OK && r < ROWS; r++)
                accumulate(b, b->rows + (size_t)r * b->length,
                           times[r] * fabs(area) * b->weight[gu] * b->weight[gv]);
        }
    for (int which = 0; which < 2; which++)
        for (int g = 0; status == BATTEN_OK && g < PLACES; g++) {
            const int gu = which == 0 ? LAST : g, gv = which == 0 ? g : LAST;
            double area;
            boolean_sum(b, gu, gv);
            status = to_plane(b, quad, gu, gv, &area);
            memcpy(seam(b, quad, which, g), b->rows, 3 * b->length * sizeof(double));
        }
    return status;
}

/* How much a jump counts: enough to make the second derivatives nearly continuous. */
static const double jump_weight = 100;

/* Between quad i at u = 1 and the next at v = 1. */
static void sum_seams(variation *b)
{
    const int n = b->fill->count;
    for (int i = 0; i < n; i++)
        for (int g = 0; g < PLACES; g++) {
            double *here = seam(b, i, 0, g);
            add_product(3 * b->length, here, -1, seam(b, (i + 1) % n, 1, g));
            for (int r = 0; r < 3; r++)
                accumulate(b, here + (size_t)r * b->length,
                           times[r] * b->weight[g] * jump_weight);
        }
}

static void set_places(variation *b)
{
    double nodes[NODES], weights[NODES];
    bat_gauss(NODES, nodes, weights);
    for (int k = 0; k < PLACES; k++) {
        b->at[k] = (k / NODES + (nodes[k % NODES] + 1) / 2) / PARTS;
        b->weight[k] = weights[k % NODES] / (2 * PARTS);
    }
    b->at[FIRST] = 0;
    b->at[LAST] = 1;
}

static batten_status begin_energy(variation *b)
{
    const size_t n = (size_t)b->fill->unknowns, quads = (size_t)b->fill->count;
    const size_t room = ALL_PLACES * 4 * b->step;
    b->edges[0] = bat_array(
        2 * room + (16 + DERIVATIVES + ROWS + 6 * PLACES * quads) * b->length, sizeof(double));
    b->matrix = bat_array(2 * n * (n + 1), sizeof(double));
    b->used = bat_array(2 * n, sizeof(int));
    if (!b->edges[0] || !b->matrix || !b->used)
        return BATTEN_OUT_OF_MEMORY;
    b->edges[1] = b->edges[0] + room;
    b->corner = b->edges[1] + room;
    b->derivatives = b->corner + 16 * b->length;
    b->rows = b->derivatives + DERIVATIVES * b->length;
    b->seams = b->rows + ROWS * b->length;
    b->right = b->matrix + n * n;
    b->lu = b->right + n;
    b->solution = b->lu + n * n;
    b->pivots = b->used + n;
    set_places(b);
    return BATTEN_OK;
}

/* ---- surfaces that would not leave their sides ---- */

/* How fast the quads leave side i in its middle, in space, when they do it as the polygon's. */
static batten_status usual_speed(const variation *b, int i, double *out)
{
    const double *along = b->fill->side[i].place[FILL_BEFORE].curve[1];
    double d[3][3];
    const batten_status status = batten_surface_evaluate(b->plane[i], 1, 0, 1, d[0]);
    if (status == BATTEN_OK)
        *out = bat_norm(3, d[2]) * bat_norm(3, along) / bat_norm(3, d[1]);
    return status;
}

/* Keep an unknown at a value by a weight beside which the others are nothing. */
static void hold(variation *b, int unknown, double value)
{
    const size_t n = (size_t)b->fill->unknowns;
    double *diagonal = b->matrix + (size_t)unknown * n + (size_t)unknown;
    /* Holds the unknown at 0 to eight digits, and leaves as many to the others. */
    const double weight = 1e8 * *diagonal;
    *diagonal += weight;
    b->right[unknown] += weight * value;
}

/*
 * Curvature varies least of all where the fill does not follow its ribbons: where these stand
 * upright on the hole it would rather not leave the sides at all. What leaves a side with less
 * than a third of the usual speed, or leaves a corner between sides that are smooth there at less
 * than a third of the usual rate, is held at what is usual.
 */
static batten_status hold_slow(variation *b, bool *held, bool *changed)
{
    const int n = b->fill->count;
    double usual[BATTEN_FILL_SIDES];
    *changed = false;
    for (int i = 0; i < n; i++) {
        const batten_status status = usual_speed(b, i, &usual[i]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int i = 0; i < n; i++) {
        const bat_fill_fields *side = &b->fill->side[i];
        const bat_fill_place *p = &side->place[FILL_BEFORE];
        const double corner = (usual[i] + usual[(i + n - 1) % n]) / 2;
        if (side->middle_speed >= 0 && !held[2 * i]) {
            const batten_vec3 C = bat_vec3_of(3, p->curve[1]), T = bat_vec3_of(3, p->slope[0]);
            const double reach = bat_vec3_norm(bat_vec3_cross(C, T)) / bat_vec3_norm(C);
            held[2 * i] = b->solution[side->middle_speed] * reach < 0.3 * usual[i];
            if (held[2 * i])
                hold(b, side->middle_speed, usual[i] / reach);
            *changed |= held[2 * i];
        }
        if (side->flat_corner && side->corner_turn >= 0 && !held[2 * i + 1]) {
            held[2 * i + 1] = b->solution[side->corner_turn] < 0.3 * corner;
            if (held[2 * i + 1])
                hold(b, side->corner_turn, corner);
            *changed |= held[2 * i + 1];
        }
    }
    return BATTEN_OK;
}

static batten_status solve_unknowns(variation *b)
{
    const int n = b->fill->unknowns;
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++)
            b->lu[j * n + i] = b->lu[i * n + j] = b->matrix[i * n + j];
    const batten_status status = bat_dense_factor(n, b->lu, b->pivots);
    if (status != BATTEN_OK)
        return status;
    memcpy(b->solution, b->right, (size_t)n * sizeof(double));
    bat_dense_solve(n, b->lu, b->pivots, 1, b->solution);
    return BATTEN_OK;
}

batten_status bat_fill_relax(bat_fill *fill, batten_surface *const *plane)
{
    variation b = {.fill = fill, .plane = plane, .length = bat_fill_length(fill)};
    bool held[2 * BATTEN_FILL_SIDES] = {false}, changed = true;
    b.step = FILL_ORDERS * b.length;
    batten_status status = begin_energy(&b);
    for (int quad = 0; status == BATTEN_OK && quad < fill->count; quad++)
        status = sum_quad(&b, quad);
    if (status == BATTEN_OK)
        sum_seams(&b);
    while (status == BATTEN_OK && changed) { /* each round holds one more at least */
        status = solve_unknowns(&b);
        if (status == BATTEN_OK)
            status = hold_slow(&b, held, &changed);
    }
    if (status == BATTEN_OK)
        memcpy(fill->x, b.solution, (size_t)fill->unknowns * sizeof(double));
    bat_release(b.used);
    bat_release(b.matrix);
    bat_release(b.edges[0]);
    return status;
}
