#include "loft/cut.h"

#include "support/test.h"

/* S = (4 u, v^2 + u / 2, v) as one bicubic piece, or with a knot of u and two of v inside. */
static void make_bowl(bool refined, bat_loft_patch *patch)
{
    static const double u_inner[] = {0.25}, v_inner[] = {0.5, 0.75};
    const int more_u = refined ? 1 : 0, more_v = refined ? 2 : 0;
    double u[4 + 1 + BAT_LOFT_SUPPORT], v[4 + 2 + BAT_LOFT_SUPPORT];
    bat_loft_knots(more_u, u_inner, u);
    bat_loft_knots(more_v, v_inner, v);
    CHECK_OK(bat_loft_patch_make(4 + more_u, u, 4 + more_v, v, patch));
    for (int i = 0; i < patch->nu; i++)
        for (int j = 0; j < patch->nv; j++) {
            /* blossoms: the mean of three knots; the mean of their products in pairs */
            const double *a = u + i + 1, *b = v + j + 1;
            double *p = patch->points + 3 * (i * patch->nv + j);
            p[0] = 4 * (a[0] + a[1] + a[2]) / 3;
            p[1] = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / 3 + p[0] / 8;
            p[2] = (b[0] + b[1] + b[2]) / 3;
        }
}

#define HALF 0.70710678118654752

static const struct {
    bat_loft_cut cut;
    double u[2], v[2]; /* where it begins and ends */
} sections[] = {
    {{.kind = BAT_CUT_STATION, .m = {1}, .at = 1}, {0.25, 0.25}, {0, 1}},
    {{.kind = BAT_CUT_STATION, .m = {1}, .at = 3.5}, {0.875, 0.875}, {0, 1}},
    {{.kind = BAT_CUT_WATERLINE, .m = {0, 0, 1}, .at = 0.5}, {0, 1}, {0.5, 0.5}},
    {{.kind = BAT_CUT_WATERLINE, .m = {0, 0, 1}, .at = 0}, {0, 1}, {0, 0}},
    {{.kind = BAT_CUT_BUTTOCK, .m = {0, 1, 0}, .at = 0.75}, {0, 1}, {0.8660254037844386, 0.5}},
    {{.kind = BAT_CUT_DIAGONAL, .m = {0, HALF, HALF}, .at = HALF},
     {0, 1},
     {0.6180339887498949, 0.36602540378443865}},
};

/* Every place lies on the plane and on the patch, in order, and is laid down at right angles. */
static void check_section(const bat_loft_patch *patch, const bat_loft_cut *cut,
                          const bat_cut_trace *trace)
{
    for (int k = 0; k < trace->count; k++) {
        bat_loft_place place;
        bat_loft_place_at(patch, trace->u[k], trace->v[k], &place);
        const double *p = place.s[0][0], *plane = trace->plane + 2 * k;
        CHECK_NEAR(cut->m[0] * p[0] + cut->m[1] * p[1] + cut->m[2] * p[2], cut->at, 1e-13);
        CHECK_NEAR(plane[0], cut->m[0] != 0 ? p[1] : p[0], 1e-13);
        CHECK_NEAR(plane[1], cut->m[0] != 0 ? p[2] : p[1] * cut->m[2] - p[2] * cut->m[1],
                   1e-13);
        if (k > 0 && cut->kind == BAT_CUT_STATION)
            CHECK(trace->v[k] > trace->v[k - 1]);
        else if (k > 0)
            CHECK(trace->u[k] > trace->u[k - 1]);
    }
}

TEST(a_cut_has_its_plane_and_the_whole_of_the_patch)
{
    for (int refined = 0; refined < 2; refined++)
        for (int each = 0; each < 2; each++) {
            bat_loft_patch patch;
            bat_cut_tracer tracer;
            make_bowl(refined, &patch);
            CHECK_OK(bat_cut_tracer_make(&patch, each ? 5 : 0, 21, &tracer));
            for (int i = 0; i < COUNT(sections); i++) {
                const bat_loft_cut *cut = &sections[i].cut;
                bat_cut_find(&tracer, cut);
                const bat_cut_trace *trace = &tracer.trace;
                const int spans = refined ? (cut->kind == BAT_CUT_STATION ? 3 : 2) : 1;
                CHECK_INT(trace->count, each ? 5 * spans + 1 : 21);
                check_section(&patch, cut, trace);
                for (int end = 0; end < 2; end++) {
                    const int k = end * (trace->count - 1);
                    CHECK_NEAR(trace->u[k], sections[i].u[end], 1e-13);
                    CHECK_NEAR(trace->v[k], sections[i].v[end], 1e-13);
                }
            }
            bat_cut_tracer_free(&tracer);
            bat_loft_patch_free(&patch);
        }
}

TEST(a_plane_beside_the_patch_cuts_nothing_and_one_across_it_a_part)
{
    bat_loft_patch patch;
    bat_cut_tracer tracer;
    make_bowl(false, &patch);
    CHECK_OK(bat_cut_tracer_make(&patch, 0, 41, &tracer));
    bat_cut_find(&tracer,
                 &(bat_loft_cut){.kind = BAT_CUT_WATERLINE, .m = {0, 0, 1}, .at = 1.5});
    CHECK_INT(tracer.trace.count, 0);
    bat_cut_find(&tracer, &(bat_loft_cut){.kind = BAT_CUT_STATION, .m = {1}, .at = -0.1});
    CHECK_INT(tracer.trace.count, 0);
    /* y = v^2 + u / 2 = 1/4 from v = 1/2 at u = 0 to v = 0 at u = 1/2: 21 of the 41 lines */
    bat_cut_find(&tracer, &(bat_loft_cut){.kind = BAT_CUT_BUTTOCK, .m = {0, 1, 0}, .at = 0.25});
    CHECK_INT(tracer.trace.count, 21);
    CHECK_NEAR(tracer.trace.v[0], 0.5, 1e-13);
    CHECK_NEAR(tracer.trace.u[20], 0.5, 1e-13);
    CHECK_NEAR(tracer.trace.v[20], 0, 1e-7);
    bat_cut_tracer_free(&tracer);
    bat_loft_patch_free(&patch);
}

TEST(edges_are_seen_along_an_axis)
{
    bat_loft_patch patch;
    bat_cut_tracer tracer;
    make_bowl(false, &patch);
    CHECK_OK(bat_cut_tracer_make(&patch, 0, 11, &tracer));
    for (int sheer = 0; sheer < 2; sheer++)
        for (int axis = 1; axis <= 2; axis++) {
            bat_loft_cut cut = {.kind = sheer ? BAT_CUT_SHEER : BAT_CUT_PROFILE};
            cut.m[axis] = 1;
            bat_cut_find(&tracer, &cut);
            CHECK_INT(tracer.trace.count, 11);
            for (int k = 0; k < 11; k++) {
                CHECK_NEAR(tracer.trace.u[k], k / 10.0, 1e-15);
                CHECK(tracer.trace.v[k] == sheer);
                CHECK_NEAR(tracer.trace.plane[2 * k], 0.4 * k, 1e-14);
                /* from the side -z, from above y */
                CHECK_NEAR(tracer.trace.plane[2 * k + 1],
                           axis == 1 ? -1.0 * sheer : sheer + k / 20.0, 1e-14);
            }
        }
    bat_cut_tracer_free(&tracer);
    bat_loft_patch_free(&patch);
}

/* S = (3 u, 0, v^3): the plane z = 1e-9 is met where the distance is flat. */
TEST(places_are_exact_where_a_line_meets_a_plane_slowly)
{
    static const double place[] = {1e-9, 1e-6, 0.125, 1};
    static const double v[] = {1e-3, 1e-2, 0.5, 1};
    double knots[8];
    bat_loft_patch patch;
    bat_cut_tracer tracer;
    bat_loft_knots(0, NULL, knots);
    CHECK_OK(bat_loft_patch_make(4, knots, 4, knots, &patch));
    for (int k = 0; k < 16; k++) {
        patch.points[3 * k] = k / 4;
        patch.points[3 * k + 2] = k % 4 == 3;
    }
    CHECK_OK(bat_cut_tracer_make(&patch, 0, 5, &tracer));
    for (int k = 0; k < COUNT(place); k++) {
        bat_cut_find(&tracer, &(bat_loft_cut){
                                  .kind = BAT_CUT_WATERLINE, .m = {0, 0, 1}, .at = place[k]});
        CHECK_INT(tracer.trace.count, 5);
        for (int i = 0; i < 5; i++) {
            CHECK_NEAR(tracer.trace.u[i], i / 4., 0);
            CHECK_NEAR(tracer.trace.v[i], v[k], 1e-13 * v[k]);
        }
    }
    bat_cut_tracer_free(&tracer);
    bat_loft_patch_free(&patch);
}
