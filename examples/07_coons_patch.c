/* A Coons patch between four curves in any order, and the one B-spline surface that it is. */
#include <batten/batten.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

/* A parabola from a to b that rises in the middle. */
static batten_curve *bow(const double a[3], const double b[3], double rise)
{
    const double knots[] = {0, 0, 0, 1, 1, 1};
    double points[9];
    for (int k = 0; k < 3; k++) {
        points[k] = a[k];
        points[3 + k] = (a[k] + b[k]) / 2 + (k == 2 ? rise : 0);
        points[6 + k] = b[k];
    }
    batten_curve *curve = NULL;
    must(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

int main(void)
{
    const double corners[4][3] = {{0, 0, 0}, {4, 0, 1}, {4, 3, 0}, {0, 3, 1}};
    batten_curve *curves[4] = {bow(corners[0], corners[1], 1), bow(corners[3], corners[2], -1),
                               bow(corners[1], corners[2], 0.5),
                               bow(corners[0], corners[3], 2)};
    batten_curve *edges[4];
    must(
        batten_boundary_sides(4, (const batten_curve *const *)curves, NULL, 1e-9, NULL, edges));

    batten_ribbon sides[4];
    for (int e = 0; e < 4; e++)
        sides[e] = (batten_ribbon){.curve = edges[e]};
    batten_surface_coons_options options = batten_surface_coons_defaults();
    options.order = 2; /* with twists at the corners: no flat spots */
    options.blending_u = options.blending_v = BATTEN_BLENDING_COONS;
    batten_surface *patch = NULL, *spline = NULL;
    must(batten_surface_coons(sides, &options, NULL, &patch));
    must(batten_surface_to_nurbs(patch, 0, NULL, &spline));

    double worst = 0;
    for (int i = 0; i <= 100; i++)
        for (int j = 0; j <= 100; j++) {
            double p[3], q[3];
            must(batten_surface_evaluate(patch, i / 100.0, j / 100.0, 0, p));
            must(batten_surface_evaluate(spline, i / 100.0, j / 100.0, 0, q));
            for (int k = 0; k < 3; k++)
                worst = fmax(worst, fabs(p[k] - q[k]));
        }
    printf("%d x %d control points of degrees %d and %d, %s from the patch\n",
           batten_surface_point_count(spline, BATTEN_U),
           batten_surface_point_count(spline, BATTEN_V),
           batten_surface_degree(spline, BATTEN_U), batten_surface_degree(spline, BATTEN_V),
           worst < 1e-14 ? "less than 1e-14" : "too far");

    batten_surface_unref(spline);
    batten_surface_unref(patch);
    for (int e = 0; e < 4; e++) {
        batten_curve_unref(edges[e]);
        batten_curve_unref(curves[e]);
    }
    return 0;
}
