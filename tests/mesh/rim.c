/* Borders made by hand: their triangles, what must be finer where they are not simple, and the seeds inside. */
#include "mesh/faces/rim.h"
#include "support/test.h"

enum { MOST = 128 };

/* A plane in which (u, v) are the places, and polygons in it. */
typedef struct {
    bat_rim rim;
    bat_rim_corner corners[MOST];
    double at[MOST][2];
    int vertex_of[MOST];
    double u[2];
    int cells[1];
    bat_lattice lattice;
    bat_pairs splits;
} border;

static border *begin_border(void)
{
    border *b = test_array(1, sizeof *b);
    b->u[1] = 1;
    b->rim.corners = b->corners;
    b->rim.at = b->at;
    b->rim.vertex_of = b->vertex_of;
    for (int k = 0; k < 2; k++)
        b->lattice.axis[k] =
            (bat_lattice_axis){.count = 2, .u = b->u, .x = b->u, .cells = b->cells};
    CHECK_OK(bat_pairs_begin(&b->splits, 4));
    return b;
}

/* A closed polygon whose sides are segments 0, 1, ... of this edge; each corner is a vertex of its own. */
static void add_polygon(border *b, int edge, int count, const double (*places)[2])
{
    const int first = b->rim.count;
    CHECK(first + count <= MOST);
    for (int i = 0; i < count; i++) {
        b->corners[first + i] = (bat_rim_corner){.uv = {places[i][0], places[i][1]},
                                                 .vertex = first + i,
                                                 .next = first + (i + 1) % count,
                                                 .edge = edge,
                                                 .segment = i};
        b->at[first + i][0] = places[i][0];
        b->at[first + i][1] = places[i][1];
    }
    b->rim.count = first + count;
}

static bool make_triangles(border *b, bat_sides *sides)
{
    bool is_simple = false;
    CHECK_OK(bat_rim_triangles(&b->rim, &b->lattice, sides, &b->splits, &is_simple));
    if (!is_simple)
        CHECK(!sides->triangles && !sides->at);
    return is_simple;
}

static bool has_split(const border *b, int edge, int segment)
{
    return bat_pairs_find(&b->splits, edge, segment) >= 0;
}

/* The area of the triangles inside. */
static double inner_area(const bat_sides *s)
{
    double all = 0;
    for (int t = 0; t < s->count; t++) {
        const double *a = s->at[s->triangles[t].corner[0]],
                     *b = s->at[s->triangles[t].corner[1]],
                     *c = s->at[s->triangles[t].corner[2]];
        if (s->triangles[t].inside)
            all += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    return all;
}

static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
static const double hole[4][2] = {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}};

TEST(the_triangles_of_a_simple_border_fill_it)
{
    border *b = begin_border();
    bat_sides sides;
    batten_interval box[2];
    add_polygon(b, 3, 4, square);
    add_polygon(b, 4, 4, hole);
    CHECK(make_triangles(b, &sides));
    CHECK_NEAR(inner_area(&sides), 0.75, 1e-15);
    CHECK_INT(b->splits.count, 0);
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == 0 && box[0].b == 1 && box[1].a == 0 && box[1].b == 1);
    bat_sides_end(&sides);
    bat_pairs_end(&b->splits);
}

TEST(the_box_of_a_border_holds_its_corners_and_that_of_none_is_at_zero)
{
    static const double away[3][2] = {{-5, -4}, {-3, -7}, {-2, -6}};
    border *b = begin_border();
    batten_interval box[2] = {{9, 9}, {9, 9}};
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == 0 && box[0].b == 0 && box[1].a == 0 && box[1].b == 0);
    add_polygon(b, 0, 3, away);
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == -5 && box[0].b == -2 && box[1].a == -7 && box[1].b == -4);
    bat_pairs_end(&b->splits);
}

TEST(sides_that_cross_must_be_finer_and_others_need_not)
{
    /* A bow tie: the second side crosses the fourth. */
    static const double bow[4][2] = {{0, 0}, {1, 0}, {0.25, 1}, {0.75, 1}};
    border *b = begin_border();
    bat_sides sides;
    add_polygon(b, 7, 4, bow);
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 2);
    CHECK(has_split(b, 7, 1) && has_split(b, 7, 3));
    bat_pairs_end(&b->splits);
}

TEST(a_side_that_a_corner_touches_must_be_finer_and_so_must_those_at_the_corner)
{
    static const double touching[3][2] = {{0.5, 0}, {0.75, 0.5}, {0.25, 0.5}};
    border *b = begin_border();
    bat_sides sides;
    add_polygon(b, 0, 4, square);
    add_polygon(b, 1, 3, touching);
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 3);
    CHECK(has_split(b, 0, 0) && has_split(b, 1, 0) && has_split(b, 1, 2));
    bat_pairs_end(&b->splits);
}

TEST(corners_at_one_place_must_be_one_vertex)
{
    static const double other[3][2] = {{0, 0}, {0.5, 0.25}, {0.25, 0.5}};
    for (int is_same = 0; is_same < 2; is_same++) {
        border *b = begin_border();
        bat_sides sides;
        add_polygon(b, 0, 4, square);
        add_polygon(b, 1, 3, other);
        b->corners[4].vertex = is_same ? b->corners[0].vertex : b->corners[4].vertex;
        CHECK_INT(make_triangles(b, &sides), is_same);
        CHECK_INT(b->splits.count, is_same ? 0 : 4);
        if (is_same) {
            CHECK_INT(b->vertex_of[0], b->vertex_of[4]);
            bat_sides_end(&sides);
        } else {
            CHECK(has_split(b, 0, 0) && has_split(b, 0, 3));
            CHECK(has_split(b, 1, 0) && has_split(b, 1, 2));
        }
        bat_pairs_end(&b->splits);
    }
}

TEST(a_border_on_one_line_must_be_finer_everywhere_but_at_poles)
{
    static const double flat[4][2] = {{0, 0}, {0.25, 0}, {0.5, 0}, {1, 0}};
    border *b = begin_border();
    bat_sides sides = {0};
    add_polygon(b, 2, 4, flat);
    b->corners[1].edge = -1; /* along a pole */
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 3);
    CHECK(!has_split(b, 2, 1) && !has_split(b, -1, 1));
    bat_pairs_clear(&b->splits);
    CHECK_OK(bat_rim_refine_all(&b->rim, &b->splits));
    CHECK_INT(b->splits.count, 3);
    bat_pairs_end(&b->splits);
}

TEST(the_sides_between_given_vertices_are_refined)
{
    border *b = begin_border();
    bat_sides sides;
    bat_pairs between;
    int index;
    add_polygon(b, 5, 4, square);
    CHECK(make_triangles(b, &sides));
    CHECK_OK(bat_pairs_begin(&between, 4));
    CHECK_OK(bat_rim_refine(&b->rim, &between, &b->splits));
    CHECK_INT(b->splits.count, 0);
    for (int i = 1; i < 4; i += 2) {
        const int p = b->vertex_of[i], q = b->vertex_of[(i + 1) % 4];
        CHECK_OK(bat_pairs_add(&between, p < q ? p : q, p < q ? q : p, &index));
    }
    CHECK_OK(bat_rim_refine(&b->rim, &between, &b->splits));
    CHECK_INT(b->splits.count, 2);
    CHECK(has_split(b, 5, 1) && has_split(b, 5, 3));
    bat_sides_end(&sides);
    bat_pairs_end(&between);
    bat_pairs_end(&b->splits);
}

/* ---- seeds ---- */

/* By a ray along x over all sides. */
static bool is_inside(const border *b, const bat_seed *p)
{
    bool inside = false;
    for (int i = 0; i < b->rim.count; i++) {
        const double *a = b->at[i], *c = b->at[b->corners[i].next];
        if ((a[1] > p->y) != (c[1] > p->y) &&
            p->x < a[0] + (p->y - a[1]) / (c[1] - a[1]) * (c[0] - a[0]))
            inside = !inside;
    }
    return inside;
}

static void add_seeds(border *b, int count, test_random *random)
{
    b->lattice.seeds = test_array((size_t)count, sizeof *b->lattice.seeds);
    for (int i = 0; i < count; i++) /* lines of a lattice, ends of the box and equal ones too */
        b->lattice.seeds[i] = (bat_seed){test_random_int(random, 0, 64) / 64.0,
                                         test_random_int(random, 0, 64) / 64.0, i};
    b->lattice.seed_count = count;
}

static bool was_before(const bat_seed *seeds, int i)
{
    for (int k = 0; k < i; k++)
        if (seeds[k].x == seeds[i].x && seeds[k].y == seeds[i].y)
            return true;
    return false;
}

/* Neither the corners nor the sides of the polygons meet the places of seeds. */
static void add_ring(border *b, int edge, int count, double radius, double phase)
{
    double places[MOST][2];
    for (int i = 0; i < count; i++) {
        const double angle = phase + 2 * acos(-1) * i / count;
        places[i][0] = 0.5 + radius * cos(angle) + 1e-5;
        places[i][1] = 0.5 + radius * sin(angle) + 2e-5;
    }
    add_polygon(b, edge, count, (const double(*)[2])places);
}

TEST(the_seeds_inside_the_border_are_kept_once_and_in_their_order)
{
    enum { SEEDS = 500 };
    test_random random = test_random_begin("seeds");
    for (int shape = 0; shape < 3; shape++) {
        border *b = begin_border();
        double wide[2] = {0, 1.5};
        if (shape == 2) /* lines across the shorter side */
            b->lattice.axis[0].x = wide;
        add_ring(b, 0, 30, 0.493, 0.1);
        add_ring(b, 1, 17, 0.31, 0.2);
        add_ring(b, 2, shape == 1 ? 3 : 11, 0.17, 0.3);
        add_seeds(b, SEEDS, &random);
        bat_seed before[SEEDS];
        memcpy(before, b->lattice.seeds, sizeof before);
        CHECK_OK(bat_rim_choose_seeds(&b->rim, &b->lattice));
        int count = 0;
        for (int i = 0; i < SEEDS; i++) {
            if (!is_inside(b, &before[i]) || was_before(before, i))
                continue;
            CHECK(count < b->lattice.seed_count);
            CHECK_INT(b->lattice.seeds[count].level, before[i].level);
            CHECK(b->lattice.seeds[count].x == before[i].x &&
                  b->lattice.seeds[count].y == before[i].y);
            count++;
        }
        CHECK_INT(b->lattice.seed_count, count);
        CHECK(count > SEEDS / 8);
        bat_pairs_end(&b->splits);
    }
}

TEST(of_seeds_on_the_ends_of_the_box_none_are_inside)
{
    bat_seed seeds[] = {{0, 0.5, 0}, {1, 0.5, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, 7}};
    border *b = begin_border();
    add_polygon(b, 0, 4, square);
    b->lattice.seeds = seeds;
    b->lattice.seed_count = COUNT(seeds);
    CHECK_OK(bat_rim_choose_seeds(&b->rim, &b->lattice));
    CHECK_INT(b->lattice.seed_count, 1);
    CHECK_INT(seeds[0].level, 7);
    bat_pairs_end(&b->splits);
}
