/* Parts of surfaces between parameters of the file, in its units and in any order. */
#include "exchange/step/read/surface_text.h"

/* Surfaces #50, of which the cone has a half angle of 0.5, and which parameters are angles: u, v. */
static const struct {
    const char *text;
    bool angle[2];
} trimmed[] = {
    {"#50=PLANE('',#4);", {false, false}},
    {"#50=CYLINDRICAL_SURFACE('',#4,2.);", {true, false}},
    {"", {true, false}},
    {"#50=SPHERICAL_SURFACE('',#4,2.);", {true, true}},
    {"#50=TOROIDAL_SURFACE('',#4,5.,2.);", {true, true}},
    {"#50=SURFACE_OF_LINEAR_EXTRUSION('',#10,#7);", {false, false}},
    {"#50=SURFACE_OF_REVOLUTION('',#16,#5);", {true, false}},
    {"#50=OFFSET_SURFACE('',#51,0.5,.F.);#51=CYLINDRICAL_SURFACE('',#4,1.5);", {true, false}},
};

/* Their points by the formulas of ISO 10303-42; x of the frame is Y, its y is -X. */
static void trimmed_point(int k, double u, double v, double out[3])
{
    const double r = k == 1 || k == 7 ? 2
                     : k == 2         ? 2 + v * tan(0.5)
                     : k == 3         ? 2 * cos(v)
                     : k == 4         ? 5 + 2 * cos(v)
                     : k == 6         ? 4 + 3 * v /* the line stands at Y, u = 0 there */
                                      : 0;
    const double z = k == 3 || k == 4 ? 2 * sin(v) : k == 6 ? 4 * v : v;
    out[0] = 1 - r * sin(u);
    out[1] = 2 + r * cos(u);
    out[2] = 3 + z;
    if (k == 0)
        memcpy(out, (double[3]){1 - v, 2 + u, 3}, 3 * sizeof *out);
    if (k == 5)
        memcpy(out, (double[3]){1, 6 + 3 * u, 3 + 2 * v}, 3 * sizeof *out);
}

/* u from 0.5 to 1.25 and v from 0.25 to 1, in units of the file, written in any order. */
static batten_surface *trimmed_surface(int k, const bool forward[2],
                                       const bat_step_scale *scale)
{
    char data[600], base[300];
    double at[2][2] = {{0.5, 1.25}, {0.25, 1}};
    for (int d = 0; d < 2; d++) /* lengths of the plane, cylinder and cone are the file's */
        for (int i = 0; i < 2; i++)
            at[d][i] /= trimmed[k].angle[d] ? scale->angle : 1;
    snprintf(base, sizeof base, "%s", trimmed[k].text);
    if (k == 2)
        snprintf(base, sizeof base, "#50=CONICAL_SURFACE('',#4,2.,%.17g);", 0.5 / scale->angle);
    snprintf(data, sizeof data,
             "%s#100=RECTANGULAR_TRIMMED_SURFACE('',#50,%.17g,%.17g,%.17g,%.17g,.%c.,.%c.);",
             base, at[0][!forward[0]], at[0][forward[0]], at[1][!forward[1]], at[1][forward[1]],
             forward[0] ? 'T' : 'F', forward[1] ? 'T' : 'F');
    return surface_of(data, scale);
}

TEST(step_trimmed_surfaces_are_exact_parts_in_every_unit)
{
    static const bat_step_scale scales[] = {{1, 1, 1e-6}, {10, 0.0174532925199432958, 1e-6}};
    for (int k = 0; k < 2 * COUNT(trimmed); k++)
        for (int sense = 0; sense < 4; sense++) {
            const bool forward[2] = {sense & 1, sense & 2};
            const bat_step_scale *scale = &scales[k % 2];
            batten_surface *surface = trimmed_surface(k / 2, forward, scale);
            for (int corner = 0; corner < 4; corner++) {
                const bool hu = corner & 1, hv = corner & 2;
                double expected[3];
                trimmed_point(k / 2, hu == forward[0] ? 1.25 : 0.5, hv == forward[1] ? 1 : 0.25,
                              expected);
                for (int c = 0; c < 3; c++)
                    expected[c] *= scale->length;
                check_at(surface, hu, hv, expected);
            }
            batten_surface_unref(surface);
        }
}

/* Of angles the higher is up to a turn above the lower, and a whole turn where they are the same. */
TEST(trimmed_angles_run_on_over_whole_turns)
{
    static const struct {
        const char *u;
        char sense;
        double low, high;
    } cases[] = {{"5.,1.", 'T', 5, 1 + 2 * BAT_PI},
                 {"1.,5.", 'T', 1, 5},
                 {"5.,1.", 'F', 1, 5},
                 {"1.,5.", 'F', 5, 1 + 2 * BAT_PI},
                 {"-1.,12.", 'T', -1, 12 - 4 * BAT_PI},
                 {"1.,7.283185307179586", 'T', 1, 1 + 2 * BAT_PI}};
    for (int i = 0; i < COUNT(cases); i++) {
        char data[300];
        snprintf(data, sizeof data,
                 "#50=CYLINDRICAL_SURFACE('',#4,2.);"
                 "#100=RECTANGULAR_TRIMMED_SURFACE('',#50,%s,0.,1.,.%c.,.T.);",
                 cases[i].u, cases[i].sense);
        batten_surface *surface = surface_of(data, &millimetres);
        const batten_interval domain = batten_surface_domain(surface, BATTEN_U);
        CHECK_NEAR(domain.b - domain.a, cases[i].high - cases[i].low, 1e-12);
        for (int k = 0; k < 2; k++) {
            const double angle = k == (cases[i].sense == 'T') ? cases[i].high : cases[i].low;
            check_at(surface, k, 0.5, (double[]){1 - 2 * sin(angle), 2 + 2 * cos(angle), 3.5});
        }
        batten_surface_unref(surface);
    }
}

TEST(step_parts_of_splines_and_whole_turns_are_read)
{
    batten_surface *part =
        surface_of(NET "#50=BEZIER_SURFACE('',2,3," ROWS ",.U.,.F.,.F.,.F.);"
                       "#100=RECTANGULAR_TRIMMED_SURFACE('',#50,0.25,0.75,1.,0.,.T.,.F.);",
                   &millimetres);
    batten_surface *whole =
        surface_of(NET "#100=BEZIER_SURFACE('',2,3," ROWS ",.U.,.F.,.F.,.F.);", &millimetres);
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++) {
            double at[3][3];
            evaluate(whole, 0.25 + 0.125 * i, 1 - 0.25 * j, at);
            check_at(part, 0.25 * i, 0.25 * j, at[0]);
        }
    batten_surface_unref(part);
    batten_surface_unref(whole);
    batten_surface *ball =
        surface_of("#50=SPHERICAL_SURFACE('',#4,2.);#100=RECTANGULAR_TRIMMED_SURFACE('',#50,0.,"
                   "6.283185307179586,-1.5707963267948966,1.5707963267948966,.T.,.T.);",
                   &millimetres);
    for (int i = 0; i <= 10; i++) {
        double at[3][3];
        evaluate(ball, i / 10.0, 0.3 + i / 20.0, at);
        CHECK_NEAR(hypot(hypot(at[0][0] - 1, at[0][1] - 2), at[0][2] - 3), 2, 1e-14);
    }
    CHECK(batten_surface_is_closed(ball, BATTEN_U, 1e-12));
    batten_surface_unref(ball);
}
