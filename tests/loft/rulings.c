#include "loft/planks.h"

#include "numeric/vector.h"
#include "support/test.h"

enum { STATIONS = 9, N = BAT_PLANK_RULINGS };

/* y and z of the lower line, 0, and the upper, 1, at x from 0 to 1. */
typedef void place(double x, int line, double yz[2]);

/* Nothing is kept of a failure. */
static batten_status try_rails(const batten_offset_table *table, bat_hull_rails *out)
{
    const batten_loft_options options = batten_loft_defaults(1e-3);
    const batten_status status = bat_hull_rails_make(table, &options, out);
    if (status != BATTEN_OK)
        bat_hull_rails_free(out);
    return status;
}

static void make_rails(place *at, bat_hull_rails *out, batten_offset_table **table)
{
    static const batten_table_line lines[] = {{"keel", false, 0}, {"sheer", false, 0}};
    batten_table_point points[STATIONS][2];
    batten_table_station stations[STATIONS];
    for (int i = 0; i < STATIONS; i++) {
        const double x = i / (STATIONS - 1.);
        for (int j = 0; j < 2; j++) {
            double yz[2];
            at(x, j, yz);
            points[i][j] = (batten_table_point){x, yz[0], yz[1], j};
        }
        stations[i] = (batten_table_station){"", x, 2, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, 2, lines, STATIONS, stations, table));
    CHECK_OK(try_rails(*table, out));
}

static void find_rulings(place *at, bat_plank_ruling *rulings)
{
    bat_hull_rails rails;
    batten_offset_table *table = NULL;
    make_rails(at, &rails, &table);
    CHECK(bat_hull_is_plank(&rails, 0));
    CHECK_OK(bat_plank_find_rulings(&rails, 0, rulings));
    bat_hull_rails_free(&rails);
    batten_offset_table_unref(table);
}

/* A cylinder whose rulings lead 0.0437 forward, which is none of the places that are tried. */
static const double lead = 0.0437;

static void at_cylinder(double x, int line, double yz[2])
{
    const double s = x - line * lead;
    yz[0] = 1 + 0.4 * line - 0.8 * (s - 0.3) * (s - 0.3);
    yz[1] = 0.7 * line;
}

TEST(rulings_of_an_oblique_cylinder_lead_as_far_as_it_does)
{
    bat_plank_ruling rulings[N];
    find_rulings(at_cylinder, rulings);
    for (int i = 0; i < N; i++) {
        CHECK(rulings[i].u == i / (N - 1.));
        if (rulings[i].u + lead < 1) {
            CHECK_NEAR(rulings[i].w, rulings[i].u + lead, 1e-9);
            CHECK(bat_plank_warp(rulings + i) < 1e-12);
        }
        CHECK(rulings[i].w <= 1 && (i == 0 || rulings[i].w >= rulings[i - 1].w));
    }
}

/* A cone about (0.4, 0, 3): the upper line is the lower, a parabola at z = 0, a tenth of the way to
 * there, each x + (0.4 - x) / 10 from x. */
static void at_cone(double x, int line, double yz[2])
{
    const double s = line ? (x - 0.04) / 0.9 : x;
    yz[0] = (1.5 - s * s) * (line ? 0.9 : 1);
    yz[1] = line ? 0.3 : 0;
}

TEST(rulings_of_a_cone_run_towards_its_apex)
{
    bat_plank_ruling rulings[N];
    find_rulings(at_cone, rulings);
    for (int i = 0; i < N; i++) {
        CHECK_NEAR(rulings[i].w, 0.9 * rulings[i].u + 0.04, 1e-9);
        CHECK(bat_plank_warp(rulings + i) < 1e-12);
    }
}

/* The lower line straight, the upper straight and turned against it: nowhere is the warp 0. */
static void at_twisted(double x, int line, double yz[2])
{
    yz[0] = 1 + line;
    yz[1] = line ? 0.2 + 0.3 * x : 0;
}

TEST(a_twisted_plank_has_the_warp_of_its_formula_at_every_ruling)
{
    bat_plank_ruling rulings[N];
    find_rulings(at_twisted, rulings);
    for (int i = 0; i < N; i++) {
        const bat_plank_ruling *r = rulings + i;
        const double dx = r->w - r->u, dz = 0.2 + 0.3 * r->w;
        /* (1, 0, 0) and (1, 0, 0.3) by (dx, 1, dz) */
        const double low[3] = {0, -dz, 1}, high[3] = {-0.3, 0.3 * dx - dz, 1};
        const double sizes = bat_norm(3, low) * bat_norm(3, high);
        CHECK_NEAR(r->cosine, bat_dot(3, low, high) / sizes, 1e-12);
        CHECK_NEAR(fabs(r->sine), 0.3 * sqrt(dx * dx + 1 + dz * dz) / sizes, 1e-12);
        CHECK_NEAR(bat_plank_warp(r), bat_acos(r->cosine), 1e-12);
        CHECK(fabs(dx) <= 0.12);
    }
}
