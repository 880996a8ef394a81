/* The corners of cells that are small enough. */
#include "mesh/faces/lattice.h"

#include <string.h>

typedef struct {
    double x, y, w, h; /* in the plane */
    int level;
} cell;

enum { DEEPEST = 48 };

static batten_status grow_seeds(bat_lattice *l, const bat_meshing *m)
{
    if (l->seed_count > 2 * (double)m->most + 1000)
        return bat_fail(BATTEN_TOO_LARGE, "a face needs more than %d triangles", m->most);
    const int room = bat_max_int(256, 2 * l->seed_room);
    bat_seed *seeds = bat_resize(l->seeds, (size_t)room, sizeof *seeds);
    if (!seeds)
        return BATTEN_OUT_OF_MEMORY;
    l->seeds = seeds;
    l->seed_room = room;
    return BATTEN_OK;
}

static batten_status add_seed(bat_lattice *l, const bat_meshing *m, double x, double y,
                              int level)
{
    if (l->seed_count == l->seed_room) {
        const batten_status status = grow_seeds(l, m);
        if (status != BATTEN_OK)
            return status;
    }
    l->seeds[l->seed_count++] = (bat_seed){x, y, level};
    return BATTEN_OK;
}

/* What the cell is too large for: `excess[d]` is how much along u and v, over 1 in all when it
 * must be halved. */
static batten_status judge(const bat_lattice *l, const bat_meshing *m, const cell *c,
                           double excess[2], bool *halve)
{
    const double u0 = bat_lattice_from_plane(&l->axis[0], c->x + c->w / 1024);
    const double u1 = bat_lattice_from_plane(&l->axis[0], c->x + c->w * 1023 / 1024);
    const double v0 = bat_lattice_from_plane(&l->axis[1], c->y + c->h / 1024);
    const double v1 = bat_lattice_from_plane(&l->axis[1], c->y + c->h * 1023 / 1024);
    double uv[4][2], d[4][18];
    for (int i = 0; i < 4; i++) {
        uv[i][0] = u0 + (i % 2 ? 0.75 : 0.25) * (u1 - u0);
        uv[i][1] = v0 + (i / 2 ? 0.75 : 0.25) * (v1 - v0);
        bat_sheet_wrap(l->sheet, uv[i]);
    }
    const batten_status status =
        batten_surface_evaluate_many(l->sheet->surface, 4, uv[0], 2, NULL, d[0]);
    if (status != BATTEN_OK)
        return status;
    bat_lattice_bounds most = {.length = {0}};
    for (int i = 0; i < 4; i++) {
        bat_lattice_bounds b;
        bat_lattice_bound(d[i], &b);
        for (int k = 0; k < 3; k++)
            most.bend[k] = bat_max(most.bend[k], b.bend[k]);
        for (int k = 0; k < 2; k++) {
            most.length[k] = bat_max(most.length[k], b.length[k]);
            most.turn[k] = bat_max(most.turn[k], b.turn[k]);
        }
    }
    const double h[2] = {u1 - u0, v1 - v0}, bend[2] = {most.bend[0], most.bend[2]};
    const double mixed = 2 * h[0] * h[1] * most.bend[1] / (8 * m->fine);
    double rise = mixed, turn = 0, reach = 0;
    for (int k = 0; k < 2; k++) {
        const double tilted = bat_lattice_tilt(m) * h[1 - k] * most.length[1 - k];
        const double own =
            h[k] * h[k] * bend[k] / (8 * (tilted > 0 ? bat_min(m->fine, tilted) : m->fine));
        const double angle = h[k] * most.turn[k] / m->angle;
        const double length = h[k] * most.length[k];
        rise += own;
        turn = bat_hypot(turn, angle);
        reach = bat_hypot(reach, length);
        excess[k] =
            bat_max(bat_max(own, angle * angle), length * length / (m->longest * m->longest));
        /* A twist asks for shorter cells both ways: the longer goes first. */
        excess[k] += 1e-3 * mixed * length;
    }
    *halve = (rise > 1.05 || turn > 1.05 || reach > m->longest) && reach > m->fine;
    return BATTEN_OK;
}

/* The ends of the line that halves the cell are seeds; the halves wait. */
static batten_status halve_cell(bat_lattice *l, const bat_meshing *m, const cell *c,
                                bool along_u, cell *stack, int *count)
{
    const int level = c->level + 1;
    cell low = *c, high = *c;
    low.level = high.level = level;
    batten_status status;
    if (along_u) {
        low.w = high.w = c->w / 2;
        high.x += high.w;
        status = add_seed(l, m, high.x, c->y, level);
        if (status == BATTEN_OK)
            status = add_seed(l, m, high.x, c->y + c->h, level);
    } else {
        low.h = high.h = c->h / 2;
        high.y += high.h;
        status = add_seed(l, m, c->x, high.y, level);
        if (status == BATTEN_OK)
            status = add_seed(l, m, c->x + c->w, high.y, level);
    }
    stack[(*count)++] = high;
    stack[(*count)++] = low;
    return status;
}

static batten_status divide(bat_lattice *l, bat_meshing *m, const cell *root)
{
    cell stack[DEEPEST + 4];
    int count = 0;
    batten_status status = BATTEN_OK;
    const double enough = bat_lattice_enough(l->predicted);
    stack[count++] = *root;
    while (status == BATTEN_OK && count) {
        const cell c = stack[--count];
        double excess[2];
        bool halve = false;
        status = bat_work_step(&m->work, 1, 0, "triangles of a face");
        if (status == BATTEN_OK)
            status = judge(l, m, &c, excess, &halve);
        if (status == BATTEN_OK && halve && c.level < DEEPEST && l->seed_count < enough)
            status = halve_cell(l, m, &c, excess[0] >= excess[1], stack, &count);
    }
    return status;
}

static batten_status add_roots(bat_lattice *l, const bat_meshing *m)
{
    const bat_lattice_axis *a = &l->axis[0], *b = &l->axis[1];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < a->count; i++)
        for (int p = 0; p < (i + 1 < a->count ? a->cells[i] : 1); p++) {
            const double w = i + 1 < a->count ? (a->x[i + 1] - a->x[i]) / a->cells[i] : 0;
            for (int j = 0; status == BATTEN_OK && j < b->count; j++)
                for (int q = 0; status == BATTEN_OK && q < (j + 1 < b->count ? b->cells[j] : 1);
                     q++) {
                    const double h =
                        j + 1 < b->count ? (b->x[j + 1] - b->x[j]) / b->cells[j] : 0;
                    status = add_seed(l, m, a->x[i] + p * w, b->x[j] + q * h, 0);
                }
        }
    return status;
}

static batten_status divide_all(bat_lattice *l, bat_meshing *m)
{
    const bat_lattice_axis *a = &l->axis[0], *b = &l->axis[1];
    batten_status status = BATTEN_OK;
    for (int i = 0; i + 1 < a->count; i++)
        for (int p = 0; status == BATTEN_OK && p < a->cells[i]; p++) {
            const double w = (a->x[i + 1] - a->x[i]) / a->cells[i];
            for (int j = 0; status == BATTEN_OK && j + 1 < b->count; j++) {
                const double h = (b->x[j + 1] - b->x[j]) / b->cells[j];
                for (int q = 0; status == BATTEN_OK && q < b->cells[j]; q++) {
                    const cell root = {a->x[i] + p * w, b->x[j] + q * h, w, h, 0};
                    status = divide(l, m, &root);
                }
            }
        }
    return status;
}

/* Coarse ones first, else in their order. */
static batten_status sort_seeds(bat_lattice *l)
{
    bat_seed *sorted = bat_array((size_t)l->seed_count, sizeof *sorted);
    if (!sorted)
        return BATTEN_OUT_OF_MEMORY;
    int first[DEEPEST + 3] = {0};
    for (int i = 0; i < l->seed_count; i++)
        first[l->seeds[i].level + 1]++;
    for (int i = 0; i <= DEEPEST + 1; i++)
        first[i + 1] += first[i];
    for (int i = 0; i < l->seed_count; i++)
        sorted[first[l->seeds[i].level]++] = l->seeds[i];
    bat_release(l->seeds);
    l->seeds = sorted;
    l->seed_room = l->seed_count;
    return BATTEN_OK;
}

batten_status bat_lattice_seeds(bat_lattice *l, bat_meshing *m)
{
    batten_status status = add_roots(l, m);
    if (status == BATTEN_OK)
        status = divide_all(l, m);
    return status == BATTEN_OK ? sort_seeds(l) : status;
}
