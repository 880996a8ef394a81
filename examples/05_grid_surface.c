/* A surface through a grid of points, and its Gaussian curvature. */
#include <batten/batten.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT_U = 12, COUNT_V = 9 };

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

int main(void)
{
    double points[COUNT_U][COUNT_V][3];
    for (int i = 0; i < COUNT_U; i++)
        for (int j = 0; j < COUNT_V; j++) {
            const double x = 0.4 * i, y = 0.5 * j;
            points[i][j][0] = x;
            points[i][j][1] = y;
            points[i][j][2] = 0.3 * sin(x) * cos(y);
        }

    batten_surface *surface = NULL;
    batten_surface_interpolate_report report;
    must(batten_surface_interpolate((batten_grid){3, COUNT_U, COUNT_V, &points[0][0][0]}, NULL,
                                    NULL, (batten_uv_out){NULL, NULL}, &report, &surface));
    printf("residual %.2g\n", report.error);

    for (int i = 0; i <= 4; i++) {
        batten_surface_local at;
        must(batten_surface_local_at(surface, i / 4.0, 0.5, &at));
        printf("u = %.2f: K = %+.5f, H = %+.5f\n", i / 4.0, at.gaussian, at.mean);
    }
    batten_surface_unref(surface);
    return 0;
}
