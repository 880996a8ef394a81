/* Triangles with kept sides on a grid, and brute force. */
#include "mesh/faces/side_scene.h"

#include <math.h>

void scene_point(scene *c, int x, int y)
{
    CHECK(c->count < MOST_POINTS);
    c->at[c->count][0] = (double)x / UNIT;
    c->at[c->count++][1] = (double)y / UNIT;
}

long long scene_whole(const scene *c, int vertex, int k)
{
    return llrint(c->triangles.at[vertex][k] * UNIT);
}

long long scene_area(const scene *c, int p, int q, int r)
{
    const long long ax = scene_whole(c, q, 0) - scene_whole(c, p, 0),
                    ay = scene_whole(c, q, 1) - scene_whole(c, p, 1);
    const long long bx = scene_whole(c, r, 0) - scene_whole(c, p, 0),
                    by = scene_whole(c, r, 1) - scene_whole(c, p, 1);
    return ax * by - ay * bx;
}

static int sign(long long a)
{
    return (a > 0) - (a < 0);
}

/* Is d within the circle through a, b, c, which turn to the left? */
static int in_circle(const scene *s, int a, int b, int c, int d)
{
    long long m[3][3];
    const int of[3] = {a, b, c};
    for (int i = 0; i < 3; i++) {
        m[i][0] = scene_whole(s, of[i], 0) - scene_whole(s, d, 0);
        m[i][1] = scene_whole(s, of[i], 1) - scene_whole(s, d, 1);
        m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
    }
    return sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

/* Is p between a and b, on the line? */
static bool is_between(const scene *c, int a, int b, int p)
{
    if (p == a || p == b || scene_area(c, a, b, p) != 0)
        return false;
    long long along = 0, whole_length = 0;
    for (int k = 0; k < 2; k++) {
        const long long d = scene_whole(c, b, k) - scene_whole(c, a, k);
        along += d * (scene_whole(c, p, k) - scene_whole(c, a, k));
        whole_length += d * d;
    }
    return along > 0 && along < whole_length;
}

static bool is_crossed(const scene *c, int a, int b, const int side[2])
{
    return sign(scene_area(c, a, b, side[0])) * sign(scene_area(c, a, b, side[1])) < 0 &&
           sign(scene_area(c, side[0], side[1], a)) * sign(scene_area(c, side[0], side[1], b)) <
               0;
}

bool scene_has_side(const scene *c, int a, int b)
{
    for (int i = 0; i < c->side_count; i++)
        if ((c->sides[i][0] == a && c->sides[i][1] == b) ||
            (c->sides[i][0] == b && c->sides[i][1] == a))
            return true;
    return false;
}

static int next3(int k)
{
    return (k + 1) % 3;
}

long long scene_check(const scene *c)
{
    const bat_sides *s = &c->triangles;
    long long all = 0;
    int fixed = 0;
    for (int t = 0; t < s->count; t++) {
        const bat_side_triangle *here = &s->triangles[t];
        all += scene_area(c, here->corner[0], here->corner[1], here->corner[2]);
        CHECK(scene_area(c, here->corner[0], here->corner[1], here->corner[2]) > 0);
        for (int k = 0; k < 3; k++) {
            const int a = here->corner[next3(k)], b = here->corner[next3(next3(k))];
            const bool is_fixed = here->fixed >> k & 1;
            CHECK_INT(is_fixed, scene_has_side(c, a, b));
            fixed += is_fixed ? (here->beside[k] < 0 ? 2 : 1) : 0;
            if (here->beside[k] < 0)
                continue;
            const bat_side_triangle *n = &s->triangles[here->beside[k]];
            int back = 0;
            while (back < 2 && n->beside[back] != t)
                back++;
            CHECK_INT(n->beside[back], t);
            CHECK_INT(n->corner[next3(back)], b);
            CHECK_INT(n->corner[next3(next3(back))], a);
            CHECK_INT(n->odd >> back & 1, here->odd >> k & 1);
        }
    }
    CHECK_INT(fixed, 2 * c->side_count);
    for (int v = 0; v < s->vertex_count; v++) {
        const int *corner = s->triangles[s->of[v]].corner;
        CHECK(corner[0] == v || corner[1] == v || corner[2] == v);
    }
    return all;
}

void scene_check_delaunay(const scene *c)
{
    const bat_sides *s = &c->triangles;
    for (int t = 0; t < s->count; t++)
        for (int k = 0; k < 3; k++) {
            const bat_side_triangle *here = &s->triangles[t];
            if ((here->fixed >> k & 1) || here->beside[k] < 0)
                continue;
            const int *n = s->triangles[here->beside[k]].corner;
            for (int i = 0; i < 3; i++)
                CHECK(in_circle(c, here->corner[0], here->corner[1], here->corner[2], n[i]) <=
                      0);
        }
}

/* What keeping a - b must say: the first vertex or side on the way from a. */
static bat_side_result expected(const scene *c, int a, int b, int other[2])
{
    double first = 1;
    bat_side_result result = BAT_SIDE_KEPT;
    for (int v = 0; v < c->triangles.vertex_count; v++) {
        if (!is_between(c, a, b, v))
            continue;
        const int k = scene_whole(c, a, 0) != scene_whole(c, b, 0) ? 0 : 1;
        const double at = (double)(scene_whole(c, v, k) - scene_whole(c, a, k)) /
                          (double)(scene_whole(c, b, k) - scene_whole(c, a, k));
        if (at < first) {
            first = at;
            result = BAT_SIDE_TOUCHES;
            other[0] = v;
        }
    }
    for (int i = 0; i < c->side_count; i++) {
        const int p = c->sides[i][0], q = c->sides[i][1];
        if (!is_crossed(c, a, b, c->sides[i]))
            continue;
        const double from = (double)scene_area(c, p, q, a), to = (double)scene_area(c, p, q, b);
        if (from / (from - to) < first) {
            first = from / (from - to);
            result = BAT_SIDE_CROSSES;
            const bool p_is_right = scene_area(c, a, b, p) < 0;
            other[0] = p_is_right ? p : q;
            other[1] = p_is_right ? q : p;
        }
    }
    return result;
}

bat_side_result scene_keep(scene *c, int a, int b)
{
    bat_side_result result;
    int other[2] = {-1, -1}, should[2] = {-1, -1};
    const bat_side_result right = expected(c, a, b, should);
    CHECK_OK(bat_sides_keep(&c->triangles, a, b, &result, other));
    CHECK_INT(result, right);
    if (result != BAT_SIDE_KEPT)
        CHECK_INT(other[0], should[0]);
    if (result == BAT_SIDE_CROSSES)
        CHECK_INT(other[1], should[1]);
    if (result == BAT_SIDE_KEPT && !scene_has_side(c, a, b)) {
        CHECK(c->side_count < MOST_SIDES);
        c->sides[c->side_count][0] = a;
        c->sides[c->side_count++][1] = b;
    }
    return result;
}

void scene_begin(scene *c)
{
    CHECK_OK(bat_sides_begin(&c->triangles, c->count, (const double(*)[2])c->at, c->vertex_of));
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < 2; k++)
            CHECK_BITS(c->triangles.at[c->vertex_of[i]][k], c->at[i][k]);
}

/* ---- in and out ---- */

/* Corners around the centre at distances in this range, the sides between them, and where their points begin. */
static int add_star(scene *c, test_random *random, int corners, double least, double most)
{
    const int first = c->count;
    for (int i = 0; i < corners; i++) {
        const double angle = 2 * acos(-1) / corners * (i + test_random_in(random, 0, 0.3));
        const double radius = test_random_in(random, least, most);
        scene_point(c, CENTRE + (int)lrint(radius * cos(angle)),
                    CENTRE + (int)lrint(radius * sin(angle)));
    }
    return first;
}

void scene_keep_star(scene *c, int first, int corners)
{
    for (int i = 0; i < corners; i++)
        CHECK_INT(
            scene_keep(c, c->vertex_of[first + i], c->vertex_of[first + (i + 1) % corners]),
            BAT_SIDE_KEPT);
}

bool scene_is_inside(const scene *c, long long x, long long y, bool *is_on)
{
    bool inside = false;
    *is_on = false;
    for (int i = 0; i < c->side_count; i++) {
        const int *side = c->sides[i];
        const long long ax = 3 * scene_whole(c, side[0], 0) - x,
                        ay = 3 * scene_whole(c, side[0], 1) - y;
        const long long bx = 3 * scene_whole(c, side[1], 0) - x,
                        by = 3 * scene_whole(c, side[1], 1) - y;
        const long long cross = ax * by - ay * bx;
        *is_on |= cross == 0 && ax * bx + ay * by <= 0;
        if ((ay > 0) != (by > 0) && (cross > 0) == (by > ay))
            inside = !inside;
    }
    return inside;
}

long long scene_check_inside(const scene *c)
{
    long long all = 0;
    for (int t = 0; t < c->triangles.count; t++) {
        const bat_side_triangle *here = &c->triangles.triangles[t];
        long long middle[2] = {0, 0};
        bool is_on;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 2; k++)
                middle[k] += scene_whole(c, here->corner[i], k);
        CHECK_INT(here->inside, scene_is_inside(c, middle[0], middle[1], &is_on));
        all +=
            here->inside ? scene_area(c, here->corner[0], here->corner[1], here->corner[2]) : 0;
    }
    return all;
}

scene *scene_rings(test_random *random, int corners)
{
    scene *c = test_array(1, sizeof *c);
    const int outer = add_star(c, random, corners, 45, 62);
    const int hole = add_star(c, random, corners, 22, 30);
    const int island = add_star(c, random, corners, 6, 13);
    scene_begin(c);
    scene_keep_star(c, hole, corners);
    scene_keep_star(c, outer, corners);
    scene_keep_star(c, island, corners);
    CHECK_OK(bat_sides_settle(&c->triangles));
    CHECK(c->triangles.triangles[c->triangles.last].inside);
    return c;
}
