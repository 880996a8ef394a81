#include <batten/contours.h>
#include <batten/standard.h>

#include "support/test.h"

#define PI 3.14159265358979323846

static const struct {
    double from, to, pitch, turns, tolerance;
} rows[] = {{1, 1, 0.5, 3, 1e-6},
            {2, 2, -1, 0.25, 1e-9},
            {0, 1, 0, 2, 1e-6},
            {1, 0.2, 1, 5, 1e-4},
            {1, 1, 0, 1, 1e-8}};

/* The true helix at an angle over a turn. */
static void helix_at(int row, double t, double p[3])
{
    const double r = rows[row].from + (rows[row].to - rows[row].from) * t / rows[row].turns;
    p[0] = r * cos(2 * PI * t);
    p[1] = r * sin(2 * PI * t);
    p[2] = rows[row].pitch * t;
}

TEST(a_helix_is_within_the_error_that_was_proved_at_every_parameter)
{
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve *helix = NULL;
        double error = -1, worst = 0;
        CHECK_OK(batten_curve_helix((batten_interval){rows[i].from, rows[i].to}, rows[i].pitch,
                                    rows[i].turns, rows[i].tolerance, &error, &helix));
        CHECK(error > 0 && error <= rows[i].tolerance);
        const batten_interval domain = batten_curve_domain(helix);
        CHECK(domain.a == 0 && domain.b == rows[i].turns);
        CHECK_INT(batten_curve_dimension(helix), 3);
        for (int k = 0; k <= 1000; k++) {
            double p[3], q[3];
            helix_at(i, domain.b * k / 1000, p);
            CHECK_OK(batten_curve_evaluate(helix, fmin(domain.b * k / 1000, domain.b), 0, q));
            worst =
                fmax(worst, sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                                 (p[2] - q[2]) * (p[2] - q[2])));
        }
        CHECK(worst <= error);
        batten_curve_unref(helix);
    }
}

TEST(helices_that_cannot_be_are_refused)
{
    static const struct {
        double from, to, pitch, turns, tolerance;
        batten_status status;
        const char *says;
    } bad[] = {
        {1, 1, 1, 0, 1e-6, BATTEN_BAD_ARGUMENT, "0 turns; more than 0 and at most 10000"},
        {1, 1, 1, -2, 1e-6, BATTEN_BAD_ARGUMENT, "-2 turns"},
        {1, 1, 1, 10001, 1e-6, BATTEN_BAD_ARGUMENT, "10001 turns"},
        {-1, 1, 1, 1, 1e-6, BATTEN_BAD_ARGUMENT, "radii of -1 and 1"},
        {1, -1, 1, 1, 1e-6, BATTEN_BAD_ARGUMENT, "radii of 1 and -1"},
        {0, 0, 1, 1, 1e-6, BATTEN_BAD_ARGUMENT, "nor may both be 0"},
        {1, 1, 1, 1, 0, BATTEN_BAD_ARGUMENT, "tolerance"},
        {NAN, 1, 1, 1, 1e-6, BATTEN_NOT_FINITE, "a number of the helix is not finite"},
        {1, HUGE_VAL, 1, 1, 1e-6, BATTEN_NOT_FINITE, "not finite"},
        {1, 1, NAN, 1, 1e-6, BATTEN_NOT_FINITE, "not finite"},
        {1, 1, 1, HUGE_VAL, 1e-6, BATTEN_NOT_FINITE, "not finite"},
    };
    for (int i = 0; i < COUNT(bad); i++) {
        batten_curve *helix = NULL;
        double error = -1;
        CHECK_STATUS(batten_curve_helix((batten_interval){bad[i].from, bad[i].to}, bad[i].pitch,
                                        bad[i].turns, bad[i].tolerance, &error, &helix),
                     bad[i].status);
        CHECK_MESSAGE(bad[i].says);
        CHECK(error == -1 && !helix);
    }
}
