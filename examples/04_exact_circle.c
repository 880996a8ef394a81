/* Circles and spheres are exact, and stay so when knots are inserted or the degree is raised.
 */
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

/* The largest deviation of |C(u)| from 1. */
static double radius_error(const batten_curve *curve)
{
    double worst = 0;
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= 1000; i++) {
        double p[2];
        must(batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 1000, 0, p));
        worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
    }
    return worst;
}

int main(void)
{
    batten_curve *circle = NULL, *refined = NULL, *raised = NULL;
    must(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    must(batten_curve_insert_knot(circle, 0.1, 1, &refined));
    must(batten_curve_elevate(refined, 3, &raised));

    printf("circle %.2g, refined %.2g, raised to degree %d %.2g\n", radius_error(circle),
           radius_error(refined), batten_curve_degree(raised), radius_error(raised));
    const int bad = radius_error(raised) > 1e-14;
    batten_curve_unref(raised);
    batten_curve_unref(refined);
    batten_curve_unref(circle);
    return bad;
}
