/* A curve through points: make it, ask it, give it back. */
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

int main(void)
{
    const double points[][2] = {{0, 0}, {1, 0.8}, {2.5, 1.2}, {4, 0.9}, {5, 0}};
    double parameters[5];

    batten_curve *curve = NULL;
    must(batten_curve_interpolate((batten_points){2, 5, &points[0][0]}, NULL, parameters,
                                  &curve));

    double length;
    must(batten_curve_length(curve, 1e-9, NULL, &length));
    printf("degree %d, %d control points, length %.6f\n", batten_curve_degree(curve),
           batten_curve_point_count(curve), length);

    for (int i = 0; i < 5; i++) {
        batten_curve_local at;
        must(batten_curve_local_at(curve, parameters[i], BATTEN_FROM_RIGHT, &at));
        printf("u = %.3f: (%.3f, %.3f), curvature %+.4f\n", parameters[i], at.point.x,
               at.point.y, at.curvature);
    }
    batten_curve_unref(curve);
    return 0;
}
