#include "loft/hull.h"

#include "support/waterlines.h"

static const double x[] = {0, 1, 2, 3, 4}, z[] = {0, 0.5, 1, 1.5};

static double stepped(double at, double height)
{
    return at == 4 && height < 1 ? 0 : 1 + height;
}

/* The grid of `stepped` and its patch over all; release with release_graph. */
typedef struct {
    batten_offset_table *table;
    bat_hull_grid grid;
    bat_arena arena;
    bat_graph_frame frame;
    bat_loft loft;
} made_graph;

static made_graph make_graph(bool closed_fore, bool closed_foot)
{
    made_graph m = {.table = make_waterlines(5, x, 4, z, stepped)};
    CHECK_OK(bat_hull_grid_make(m.table, &m.grid));
    CHECK_OK(bat_graph_frame_all(&m.grid, &m.arena, &m.frame));
    m.frame.closed[1] = closed_fore;
    m.frame.closed_foot = closed_foot;
    CHECK_OK(bat_graph_patch(&m.grid, &m.frame, 0.01, &m.loft));
    return m;
}

static void release_graph(made_graph *m)
{
    bat_hull_release(&m->loft);
    bat_arena_free(&m->arena);
    bat_arena_free(&m->grid.arena);
    batten_offset_table_unref(m->table);
}

TEST(x_and_z_of_a_graph_are_a_map_and_held)
{
    made_graph m = make_graph(false, false);
    const bat_loft_patch *patch = &m.loft.patch;
    CHECK(m.loft.is_graph);
    CHECK_INT(patch->nu, 3 + 4 + 4); /* three stations inside, intervals halved */
    CHECK_INT(patch->nv, 2 + 3 + 4);
    for (int k = 0; k < 3 * patch->nu * patch->nv; k++)
        CHECK(m.loft.held[k] == (k % 3 != 1));
    for (int k = 0; k <= 20; k++) {
        const double u = k / 20., v = 1 - u * u;
        bat_loft_place place;
        bat_loft_place_at(patch, u, v, &place);
        CHECK_NEAR(place.s[0][0][0], 4 * u, 1e-14);
        CHECK(place.s[0][0][1] == 0);
        CHECK_NEAR(place.s[0][0][2], 1.5 * (0.4 * v + 0.6 * v * v), 1e-14);
        CHECK_NEAR(bat_graph_fall(0.6, 0.4 * v + 0.6 * v * v), v, 1e-14);
    }
    CHECK_NEAR(bat_graph_fall(0, 0.3), 0.3, 1e-16);
    release_graph(&m);
}

TEST(a_closed_end_and_foot_are_held_on_the_centre_plane_and_the_foot_is_free_to_rise)
{
    made_graph m = make_graph(true, true);
    const int nu = m.loft.patch.nu, nv = m.loft.patch.nv;
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const bool *held = m.loft.held + 3 * (i * nv + j);
            CHECK(held[0]);
            CHECK(held[1] == (j == 0 || i == nu - 1));
            CHECK(held[2] == (j > 0));
        }
    release_graph(&m);
}

TEST(points_of_the_hull_are_data_at_their_feet_and_zeros_are_none)
{
    made_graph m = make_graph(false, false);
    CHECK_INT(m.loft.datum_count, 18);
    for (int k = 0; k < m.loft.datum_count; k++) {
        const bat_loft_datum *d = m.loft.data + k;
        bat_loft_place place;
        bat_loft_place_at(&m.loft.patch, d->u, d->v, &place);
        CHECK_NEAR(place.s[0][0][0], d->point[0], 1e-12);
        CHECK_NEAR(place.s[0][0][2], d->point[2], 1e-12);
        CHECK(d->point[1] == stepped(d->point[0], d->point[2]));
        CHECK(d->in_station && d->within == 0.01 && !d->on_u_edge);
        CHECK(d->point[0] == d->station && d->point[2] == z[d->index]);
        /* Those around which there is nothing slide along their waterlines only. */
        CHECK(d->on_v_edge == (d->station == 0 || d->station == 4 || d->index == 0 ||
                               d->index == 3 || (d->station == 3 && d->index < 2)));
    }
    release_graph(&m);
}

TEST(where_there_is_no_hull_beside_it_the_graph_is_limited)
{
    made_graph m = make_graph(false, false);
    CHECK_OK(bat_graph_limit_outside(&m.grid, &m.loft));
    CHECK_INT(m.loft.limit_count, 2); /* (4, 0) and (4, 0.5) */
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(m.loft.limits[k].u, 1, 1e-12);
        CHECK_NEAR(m.loft.limits[k].v, bat_graph_fall(0.6, k / 3.), 1e-12);
        CHECK(m.loft.limits[k].most == 0.01);
    }
    release_graph(&m);
}
