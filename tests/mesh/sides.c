/* Triangles with kept sides against brute force in whole numbers, in which all decisions are exact. */
#include "mesh/faces/sides.h"
#include "support/test.h"

#include <math.h>

enum { CENTRE = 64, UNIT = 128, MOST_POINTS = 200, MOST_SIDES = 200 };

/* Points of a grid, places in units of 1/UNIT; the distinct ones have the numbers of the vertices. */
typedef struct {
    int count;
    double at[MOST_POINTS][2];
    int vertex_of[MOST_POINTS];
    int side_count, sides[MOST_SIDES][2]; /* kept */
    bat_sides triangles;
} scene;

static void add_point(scene *c, int x, int y)
{
    CHECK(c->count < MOST_POINTS);
    c->at[c->count][0] = (double)x / UNIT;
    c->at[c->count++][1] = (double)y / UNIT;
}

static long long whole(const scene *c, int vertex, int k)
{
    return llrint(c->triangles.at[vertex][k] * UNIT);
}

/* Twice the area of p, q, r, in whole units. */
static long long area(const scene *c, int p, int q, int r)
{
    const long long ax = whole(c, q, 0) - whole(c, p, 0), ay = whole(c, q, 1) - whole(c, p, 1);
    const long long bx = whole(c, r, 0) - whole(c, p, 0), by = whole(c, r, 1) - whole(c, p, 1);
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
        m[i][0] = whole(s, of[i], 0) - whole(s, d, 0);
        m[i][1] = whole(s, of[i], 1) - whole(s, d, 1);
        m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
    }
    return sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

/* Is p between a and b, on the line? */
static bool is_between(const scene *c, int a, int b, int p)
{
    if (p == a || p == b || area(c, a, b, p) != 0)
        return false;
    long long along = 0, whole_length = 0;
    for (int k = 0; k < 2; k++) {
        const long long d = whole(c, b, k) - whole(c, a, k);
        along += d * (whole(c, p, k) - whole(c, a, k));
        whole_length += d * d;
    }
    return along > 0 && along < whole_length;
}

static bool is_crossed(const scene *c, int a, int b, const int side[2])
{
    return sign(area(c, a, b, side[0])) * sign(area(c, a, b, side[1])) < 0 &&
           sign(area(c, side[0], side[1], a)) * sign(area(c, side[0], side[1], b)) < 0;
}

static bool is_kept(const scene *c, int a, int b)
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

/* Neighbours know each other and the edge between them alike, all triangles turn to the left, and together they
 * are as large as the hull. Returns twice their area. */
static long long check_triangles(const scene *c)
{
    const bat_sides *s = &c->triangles;
    long long all = 0;
    int fixed = 0;
    for (int t = 0; t < s->count; t++) {
        const bat_side_triangle *here = &s->triangles[t];
        all += area(c, here->corner[0], here->corner[1], here->corner[2]);
        CHECK(area(c, here->corner[0], here->corner[1], here->corner[2]) > 0);
        for (int k = 0; k < 3; k++) {
            const int a = here->corner[next3(k)], b = here->corner[next3(next3(k))];
            const bool is_fixed = here->fixed >> k & 1;
            CHECK_INT(is_fixed, is_kept(c, a, b));
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

/* No vertex beyond an edge that is no side lies in the circle of the triangle before it. */
static void check_delaunay(const scene *c)
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
        const int k = whole(c, a, 0) != whole(c, b, 0) ? 0 : 1;
        const double at = (double)(whole(c, v, k) - whole(c, a, k)) /
                          (double)(whole(c, b, k) - whole(c, a, k));
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
        const double from = (double)area(c, p, q, a), to = (double)area(c, p, q, b);
        if (from / (from - to) < first) {
            first = from / (from - to);
            result = BAT_SIDE_CROSSES;
            const bool p_is_right = area(c, a, b, p) < 0;
            other[0] = p_is_right ? p : q;
            other[1] = p_is_right ? q : p;
        }
    }
    return result;
}

static bat_side_result keep(scene *c, int a, int b)
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
    if (result == BAT_SIDE_KEPT && !is_kept(c, a, b)) {
        CHECK(c->side_count < MOST_SIDES);
        c->sides[c->side_count][0] = a;
        c->sides[c->side_count++][1] = b;
    }
    return result;
}

static void begin_triangles(scene *c)
{
    CHECK_OK(bat_sides_begin(&c->triangles, c->count, (const double(*)[2])c->at, c->vertex_of));
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < 2; k++)
            CHECK_BITS(c->triangles.at[c->vertex_of[i]][k], c->at[i][k]);
}

TEST(random_sides_are_kept_until_they_cross_or_touch_others)
{
    test_random random = test_random_begin("random sides");
    for (int round = 0; round < test_cases(60); round++) {
        scene *c = test_array(1, sizeof *c);
        /* Coarse grids have many points on lines and on circles. */
        const int side = round % 3 == 0 ? 6 : round % 3 == 1 ? 15 : UNIT;
        add_point(c, 0, 0);
        add_point(c, side, 0);
        add_point(c, 0, side);
        for (int i = test_random_int(&random, 2, 40); i > 0; i--)
            add_point(c, test_random_int(&random, 0, side), test_random_int(&random, 0, side));
        begin_triangles(c);
        const long long hull = check_triangles(c);
        check_delaunay(c);
        for (int i = 0; i < 60; i++) {
            const int a = test_random_int(&random, 0, c->triangles.vertex_count - 1);
            const int b = test_random_int(&random, 0, c->triangles.vertex_count - 1);
            if (a == b)
                continue;
            keep(c, a, b);
            CHECK_INT(check_triangles(c), hull);
        }
        CHECK_OK(bat_sides_settle(&c->triangles));
        CHECK_INT(check_triangles(c), hull);
        check_delaunay(c);
        bat_sides_end(&c->triangles);
        CHECK(!c->triangles.at && !c->triangles.triangles && c->triangles.count == 0);
    }
}

/* ---- in and out ---- */

/* Corners around the centre at distances in this range, the sides between them, and where their points begin. */
static int add_star(scene *c, test_random *random, int corners, double least, double most)
{
    const int first = c->count;
    for (int i = 0; i < corners; i++) {
        const double angle = 2 * acos(-1) / corners * (i + test_random_in(random, 0, 0.3));
        const double radius = test_random_in(random, least, most);
        add_point(c, CENTRE + (int)lrint(radius * cos(angle)),
                  CENTRE + (int)lrint(radius * sin(angle)));
    }
    return first;
}

static void keep_star(scene *c, int first, int corners)
{
    for (int i = 0; i < corners; i++)
        CHECK_INT(keep(c, c->vertex_of[first + i], c->vertex_of[first + (i + 1) % corners]),
                  BAT_SIDE_KEPT);
}

/* By the sides that a ray to the right meets: x and y in thirds of units, so that middles are whole. On a side:
 * *is_on. */
static bool is_inside(const scene *c, long long x, long long y, bool *is_on)
{
    bool inside = false;
    *is_on = false;
    for (int i = 0; i < c->side_count; i++) {
        const int *side = c->sides[i];
        const long long ax = 3 * whole(c, side[0], 0) - x, ay = 3 * whole(c, side[0], 1) - y;
        const long long bx = 3 * whole(c, side[1], 0) - x, by = 3 * whole(c, side[1], 1) - y;
        const long long cross = ax * by - ay * bx;
        *is_on |= cross == 0 && ax * bx + ay * by <= 0;
        if ((ay > 0) != (by > 0) && (cross > 0) == (by > ay))
            inside = !inside;
    }
    return inside;
}

/* Twice the area of what is inside. */
static long long check_inside(const scene *c)
{
    long long all = 0;
    for (int t = 0; t < c->triangles.count; t++) {
        const bat_side_triangle *here = &c->triangles.triangles[t];
        long long middle[2] = {0, 0};
        bool is_on;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 2; k++)
                middle[k] += whole(c, here->corner[i], k);
        CHECK_INT(here->inside, is_inside(c, middle[0], middle[1], &is_on));
        all += here->inside ? area(c, here->corner[0], here->corner[1], here->corner[2]) : 0;
    }
    return all;
}

/* An outer border, a hole, an island in the hole. */
static scene *make_rings(test_random *random, int corners)
{
    scene *c = test_array(1, sizeof *c);
    const int outer = add_star(c, random, corners, 45, 62);
    const int hole = add_star(c, random, corners, 22, 30);
    const int island = add_star(c, random, corners, 6, 13);
    begin_triangles(c);
    keep_star(c, hole, corners);
    keep_star(c, outer, corners);
    keep_star(c, island, corners);
    CHECK_OK(bat_sides_settle(&c->triangles));
    CHECK(c->triangles.triangles[c->triangles.last].inside);
    return c;
}

TEST(a_hole_is_out_and_an_island_in_it_is_in)
{
    test_random random = test_random_begin("rings");
    for (int round = 0; round < test_cases(20); round++) {
        scene *c = make_rings(&random, 20);
        check_triangles(c);
        check_delaunay(c);
        CHECK(check_inside(c) > 0);
        bat_sides_end(&c->triangles);
    }
}

TEST(a_side_that_is_kept_twice_does_not_part_in_and_out)
{
    scene *c = test_array(1, sizeof *c);
    add_point(c, 0, 0);
    add_point(c, 8, 0);
    add_point(c, 8, 8);
    add_point(c, 0, 8);
    begin_triangles(c);
    keep_star(c, 0, 4);
    for (int i = 0; i < 2; i++)
        keep(c, c->vertex_of[0], c->vertex_of[2]);
    CHECK_OK(bat_sides_settle(&c->triangles));
    check_triangles(c);
    CHECK_INT(c->triangles.count, 2);
    CHECK(c->triangles.triangles[0].inside && c->triangles.triangles[1].inside);
    bat_sides_end(&c->triangles);
}

TEST(points_that_are_equal_are_one_vertex)
{
    scene *c = test_array(1, sizeof *c);
    for (int i = 0; i < 2; i++) {
        add_point(c, 0, 0);
        add_point(c, 8, 0);
        add_point(c, 0, 8);
    }
    begin_triangles(c);
    CHECK_INT(c->triangles.vertex_count, 3);
    CHECK_INT(c->triangles.count, 1);
    for (int i = 0; i < 3; i++)
        CHECK_INT(c->vertex_of[i], c->vertex_of[i + 3]);
    bat_sides_end(&c->triangles);
    c->count = 2;
    CHECK_STATUS(bat_sides_begin(&c->triangles, 2, (const double(*)[2])c->at, c->vertex_of),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(!c->triangles.at && !c->triangles.triangles);
}

/* ---- points ---- */

static bool is_vertex(const scene *c, long long x, long long y)
{
    for (int v = 0; v < c->triangles.vertex_count; v++)
        if (whole(c, v, 0) == x && whole(c, v, 1) == y)
            return true;
    return false;
}

/* The new triangles are those around the vertex: inside, to be looked at again, younger than before. */
static void check_new(const scene *c, int vertex)
{
    int around = 0;
    for (int t = 0; t < c->triangles.count; t++) {
        const bat_side_triangle *here = &c->triangles.triangles[t];
        if (here->corner[0] != vertex && here->corner[1] != vertex && here->corner[2] != vertex)
            continue;
        around++;
        CHECK(here->inside && !here->done && here->born > 0);
    }
    CHECK(around >= 3);
}

TEST(points_inside_are_put_in_and_all_others_are_not)
{
    test_random random = test_random_begin("points");
    for (int round = 0; round < test_cases(8); round++) {
        scene *c = make_rings(&random, 12 + round);
        const long long hull = check_triangles(c), inner = check_inside(c);
        int taken = 0;
        for (int i = 0; i < 120; i++) {
            const int x = test_random_int(&random, 0, UNIT),
                      y = test_random_int(&random, 0, UNIT);
            const double point[2] = {(double)x / UNIT, (double)y / UNIT};
            bool is_on;
            const bool inside = is_inside(c, 3LL * x, 3LL * y, &is_on);
            const bool should = inside && !is_on && !is_vertex(c, x, y);
            int vertex = -7;
            CHECK_OK(bat_sides_insert(&c->triangles, point, -1, 0, &vertex));
            CHECK_INT(vertex, should ? c->triangles.vertex_count - 1 : -1);
            CHECK(c->triangles.near[0] == -1 && c->triangles.near[1] == -1);
            if (!should)
                continue;
            taken++;
            CHECK(whole(c, vertex, 0) == x && whole(c, vertex, 1) == y);
            check_new(c, vertex);
        }
        CHECK(taken > 20);
        CHECK_INT(check_triangles(c), hull);
        CHECK_INT(check_inside(c), inner);
        check_delaunay(c);
        CHECK(c->triangles.steps >= 120);
        bat_sides_end(&c->triangles);
    }
}

/* Seen from the vertex: the cosine between the ends of the side, and the nearer end in parts of its length. */
static void see_side(const double *p, const double *a, const double *b, double *cosine,
                     double *nearest)
{
    const double to_a = hypot(a[0] - p[0], a[1] - p[1]), to_b = hypot(b[0] - p[0], b[1] - p[1]);
    *cosine = ((a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])) / (to_a * to_b);
    *nearest = fmin(to_a, to_b) / hypot(b[0] - a[0], b[1] - a[1]);
}

TEST(points_near_a_side_are_not_put_in_and_the_side_is_named)
{
    enum { WIDEST_BY_TENTHS = 2 };
    const double widest = -0.1 * WIDEST_BY_TENTHS, least = 0.25, room = 1e-12;
    test_random random = test_random_begin("near sides");
    int refused_by_angle = 0, refused_by_end = 0, taken = 0;
    for (int round = 0; round < test_cases(8); round++) {
        scene *c = make_rings(&random, 16);
        for (int i = 0; i < 150; i++) {
            const double point[2] = {test_random_int(&random, 0, UNIT) / (double)UNIT,
                                     test_random_int(&random, 0, UNIT) / (double)UNIT};
            const int before = c->triangles.vertex_count;
            int vertex;
            double cosine, nearest;
            CHECK_OK(bat_sides_insert(&c->triangles, point, widest, least, &vertex));
            CHECK_INT(c->triangles.vertex_count, before + (vertex >= 0));
            const bat_sides *s = &c->triangles;
            if (vertex < 0 && s->near[0] >= 0) {
                CHECK(is_kept(c, s->near[0], s->near[1]));
                see_side(point, s->at[s->near[0]], s->at[s->near[1]], &cosine, &nearest);
                CHECK(cosine < widest + room || nearest < least + room);
                refused_by_angle += cosine < widest;
                refused_by_end += nearest < least;
            }
            for (int t = 0; vertex >= 0 && t < s->count; t++) {
                const bat_side_triangle *here = &s->triangles[t];
                if (here->corner[0] != vertex || !(here->fixed & 1))
                    continue;
                see_side(point, s->at[here->corner[1]], s->at[here->corner[2]], &cosine,
                         &nearest);
                CHECK(cosine >= widest - room && nearest >= least - room);
                taken++;
            }
        }
        check_triangles(c);
        check_delaunay(c);
        bat_sides_end(&c->triangles);
    }
    CHECK(refused_by_angle > 0 && refused_by_end > 0 && taken > 0);
}

TEST(a_point_in_the_circles_of_many_triangles_sees_all_their_corners)
{
    enum { CORNERS = 60 };
    scene *c = test_array(1, sizeof *c);
    const double middle[2] = {0.5, 0.5};
    int vertex, around = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double angle = 2 * acos(-1) / CORNERS * i;
        add_point(c, CENTRE + (int)lrint(62 * cos(angle)),
                  CENTRE + (int)lrint(62 * sin(angle)));
    }
    begin_triangles(c);
    keep_star(c, 0, CORNERS);
    CHECK_OK(bat_sides_settle(&c->triangles));
    CHECK_OK(bat_sides_insert(&c->triangles, middle, -1, 0, &vertex));
    CHECK_INT(vertex, CORNERS);
    CHECK_INT(c->triangles.count, CORNERS);
    for (int t = 0; t < CORNERS; t++)
        around += c->triangles.triangles[t].corner[0] == vertex;
    CHECK(around > 40);
    check_triangles(c);
    bat_sides_end(&c->triangles);
}
