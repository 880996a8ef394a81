/* The seeds inside a border. */
#include "mesh/faces/rim_scene.h"

static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

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
