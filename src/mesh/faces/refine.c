/* Triangles of a face that are not near enough get points. */
#include "base/plural.h"
#include "mesh/faces/face.h"

#include <stdio.h>
#include <string.h>

enum { BATCH = 256, SAMPLES = 4, MOST_ROUNDS = 64 };

/* Samples: the middle of the triangle, and of its edges. */
typedef struct {
    int triangle, born;
    double at[SAMPLES][2];
} sampling;

typedef struct {
    sampling tasks[BATCH];
    double uv[BATCH * SAMPLES][2];
    double points[BATCH * SAMPLES][3];
} batch;

static void middle(const double *a, const double *b, double *out)
{
    out[0] = (a[0] + b[0]) / 2;
    out[1] = (a[1] + b[1]) / 2;
}

static void choose_samples(const bat_face_mesh *f, int triangle, batch *b, int index)
{
    const bat_side_triangle *t = &f->sides.triangles[triangle];
    sampling *task = &b->tasks[index];
    double place[3][2];
    task->triangle = triangle;
    task->born = t->born;
    for (int k = 0; k < 3; k++)
        bat_face_place(f, t, k, place[k]);
    for (int k = 0; k < 2; k++)
        task->at[0][k] = (place[0][k] + place[1][k] + place[2][k]) / 3;
    for (int k = 0; k < 3; k++)
        middle(place[(k + 1) % 3], place[(k + 2) % 3], task->at[1 + k]);
    for (int i = 0; i < SAMPLES; i++) {
        double *uv = b->uv[SAMPLES * index + i];
        for (int k = 0; k < 2; k++)
            uv[k] = bat_lattice_from_plane(&f->lattice->axis[k], task->at[i][k]);
        bat_sheet_wrap(f->sheet, uv);
    }
}

static double distance(const double *a, const double *b)
{
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static bool is_side(const bat_side_triangle *t, int k)
{
    return t->fixed >> k & 1;
}

/* The crease that the triangle lies across: a point of it in the middle of the triangle. */
static bool cross_crease(const bat_face_mesh *f, const bat_side_triangle *t, double at[2])
{
    const double(*p)[2] = (const double(*)[2])f->sides.at;
    for (int d = 0; d < 2; d++) {
        const bat_lattice_axis *axis = &f->lattice->axis[d];
        double low = p[t->corner[0]][d], high = low;
        for (int k = 1; k < 3; k++) {
            low = bat_min(low, p[t->corner[k]][d]);
            high = bat_max(high, p[t->corner[k]][d]);
        }
        const double close = 1e-3 * (high - low);
        const int i = bat_max_int(1, bat_lattice_break(axis, low + close));
        if (i + 1 >= axis->count || axis->x[i] >= high - close)
            continue;
        const double x = axis->x[i];
        double sum = 0;
        int hits = 0;
        for (int k = 0; k < 3; k++) {
            const double *a = p[t->corner[k]], *b = p[t->corner[(k + 1) % 3]];
            if ((a[d] < x) == (b[d] < x))
                continue;
            sum += a[1 - d] + (x - a[d]) / (b[d] - a[d]) * (b[1 - d] - a[1 - d]);
            hits++;
        }
        at[d] = x;
        at[1 - d] = sum / hits;
        return true;
    }
    return false;
}

/* How far the surface is from the triangle at the samples; the worst one where a point can be
 * put in, else -1. */
static int measure_triangle(const bat_face_mesh *f, bat_side_triangle *t,
                            const double (*points)[3])
{
    const double *c[3];
    double worst = bat_meshing_limit(f->m, f->m->fine, bat_face_off(f, t));
    int place = -1;
    for (int k = 0; k < 3; k++)
        c[k] = f->vertices[t->corner[k]].point;
    t->miss = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const double miss = bat_distance_to_triangle(points[i], c[0], c[1], c[2]);
        t->miss = bat_max(t->miss, miss);
        if (miss > worst && (i == 0 || !is_side(t, i - 1))) {
            worst = miss;
            place = i;
        }
    }
    return place;
}

/* The angle between the normals at the ends of an edge, of those that are known; and the
 * longest edge, where either is too much. */
static int turn_and_length(const bat_face_mesh *f, bat_side_triangle *t)
{
    double worst = 1;
    int place = -1;
    t->turn = 0;
    for (int k = 0; k < 3; k++) {
        const bat_face_vertex *a = &f->vertices[t->corner[(k + 1) % 3]];
        const bat_face_vertex *b = &f->vertices[t->corner[(k + 2) % 3]];
        const double length = distance(a->point, b->point);
        double excess = length / f->m->longest;
        if (a->regular && b->regular && !a->on_crease && !b->on_crease && !a->pole &&
            !b->pole) {
            const double chord = distance(a->normal, b->normal) / 2;
            const double turn = 2 * bat_asin(bat_min(chord, 1));
            t->turn = bat_max(t->turn, turn);
            if (length > f->m->chord)
                excess = bat_max(excess, turn / f->m->angle);
        }
        if (excess > worst && !is_side(t, k)) {
            worst = excess;
            place = 1 + k;
        }
    }
    return place;
}

/* Does the triangle look away from where the surface looks? Where edges miss the surface, or
 * fold, or u and v run nearly the same way, small and thin ones do so however often they are
 * divided: what is within the chord may. */
static bool is_turned(const bat_face_mesh *f, const bat_side_triangle *t)
{
    const double *p[3];
    double a[3], b[3], sum = 0, longest = 0;
    for (int k = 0; k < 3; k++)
        p[k] = f->vertices[t->corner[k]].point;
    for (int k = 0; k < 3; k++)
        longest = bat_max(longest, distance(p[k], p[(k + 1) % 3]));
    if (longest <= f->m->chord)
        return false;
    for (int i = 0; i < 3; i++) {
        a[i] = p[1][i] - p[0][i];
        b[i] = p[2][i] - p[0][i];
    }
    double n[3];
    for (int i = 0; i < 3; i++)
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    for (int k = 0; k < 3; k++) {
        const bat_face_vertex *v = &f->vertices[t->corner[k]];
        for (int i = 0; i < 3 && v->regular; i++)
            sum += v->normal[i] * n[i];
    }
    const double height = bat_hypot(bat_hypot(n[0], n[1]), n[2]) / longest;
    return sum < 0 && height > 0.25 * f->m->chord;
}

/* The middle, in the plane, of the longest edge that is no side; false when all are sides. */
static bool middle_of_longest(const bat_face_mesh *f, const bat_side_triangle *t, double at[2])
{
    double longest = -1;
    for (int k = 0; k < 3; k++) {
        const int a = t->corner[(k + 1) % 3], b = t->corner[(k + 2) % 3];
        const double length = distance(f->vertices[a].point, f->vertices[b].point);
        if (is_side(t, k) || length <= longest)
            continue;
        longest = length;
        middle(f->sides.at[a], f->sides.at[b], at);
    }
    return longest >= 0;
}

/* How near to sides points may come: where an edge is straight and the surface is not, its
 * triangles need points close by. */
static const double widest = -0.9995, nearest = 0.01;

/* The side that the last point was too near to is too long. */
static batten_status blame_side(bat_face_mesh *f)
{
    const int a = f->sides.near[0], b = f->sides.near[1];
    int index;
    return a < 0 ? BATTEN_OK
                 : bat_pairs_add(&f->tight, bat_min_int(a, b), bat_max_int(a, b), &index);
}

/* Put a point into one triangle, when it needs one. */
static batten_status mend(bat_face_mesh *f, const batch *b, int index)
{
    const sampling *task = &b->tasks[index];
    bat_side_triangle *t = &f->sides.triangles[task->triangle];
    if (t->born != task->born || t->done)
        return BATTEN_OK; /* gone with another one */
    t->done = true;
    int place = measure_triangle(f, t, &b->points[SAMPLES * index]);
    const int other = turn_and_length(f, t);
    if (place < 0)
        place = other;
    if (place < 0 && is_turned(f, t))
        place = 0;
    if (place < 0)
        return BATTEN_OK;
    const bool is_beyond = t->miss > bat_meshing_limit(f->m, f->m->chord, bat_face_off(f, t));
    double at[2], other_place[2];
    bool added = false, is_at_pole = false;
    for (int k = 0; k < 3; k++)
        is_at_pole = is_at_pole || f->vertices[t->corner[k]].pole;
    memcpy(at, task->at[place], sizeof at);
    const bool has_other = middle_of_longest(f, t, other_place);
    if (is_at_pole && has_other) /* the samples are not in the triangle of the plane */
        memcpy(at, other_place, sizeof at);
    cross_crease(f, t, at);
    f->sides.last = task->triangle; /* the walk to the point begins near to it */
    batten_status status = bat_face_insert(f, at, widest, nearest, &added);
    if (status == BATTEN_OK && !added && has_other)
        status = bat_face_insert(f, other_place, widest, nearest, &added);
    if (status == BATTEN_OK && !added && is_beyond)
        status = blame_side(f);
    return status;
}

static batten_status run_batch(bat_face_mesh *f, batch *b, int count)
{
    const int first = f->count;
    batten_status status = batten_surface_evaluate_many(
        f->sheet->surface, (size_t)count * SAMPLES, b->uv[0], 0, f->m->job, b->points[0]);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = mend(f, b, i);
    if (status == BATTEN_OK)
        status = bat_face_evaluate(f, first);
    if (status == BATTEN_OK)
        status = bat_face_step(f, (uint64_t)count, 0.5);
    return status;
}

/* Where a surface turns about, or an edge lies beside it by more than the chord, triangles look
 * away however often they are divided: then it is enough, and a note says so. */
static bool is_enough(bat_face_mesh *f)
{
    if (f->sides.count <= f->enough)
        return false;
    const int face = bat_meshing_number(f->m, f->face);
    char entity[32];
    snprintf(entity, sizeof entity, "face %d", face + 1);
    if (!f->has_enough)
        batten_notes_add(f->m->notes, "", 0, entity,
                         "face %d was divided no further at %d triangle%s; some are folded, or "
                         "farther than the chord from the surface",
                         face + 1, f->sides.count, bat_plural(f->sides.count));
    f->has_enough = true;
    return true;
}

batten_status bat_face_refine(bat_face_mesh *f)
{
    batch *b = bat_array(1, sizeof *b);
    if (!b)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    bool found = true;
    for (int round = 0; status == BATTEN_OK && found && round < MOST_ROUNDS; round++) {
        int count = 0;
        found = false;
        for (int i = 0; status == BATTEN_OK && i < f->sides.count; i++) {
            const bat_side_triangle *t = &f->sides.triangles[i];
            if (count == 0 && is_enough(f))
                break;
            if (t->inside && !t->done && !bat_face_vanishes(f, t))
                choose_samples(f, i, b, count++);
            if (count == BATCH || (count && i + 1 == f->sides.count)) {
                status = run_batch(f, b, count);
                count = 0;
                found = true;
            }
        }
        if (status == BATTEN_OK && count) { /* triangles were added behind the last */
            status = run_batch(f, b, count);
            found = true;
        }
    }
    bat_release(b);
    return status;
}
