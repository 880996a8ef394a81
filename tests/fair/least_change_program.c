#include "fair/least_change.h"
#include "support/test.h"

enum { N = 6 };

static const double t[N] = {0, 1, 1.5, 3, 4, 6};

/* A piece of free ducks but for the ends, which has the places z. */
typedef struct {
    double z[2 * N], within[N], frames[4 * N];
    int freedom[N];
    bat_batten batten;
    bat_fair_piece piece;
    bat_least_change change;
} bench;

static batten_status begin_bench(int width, const double *z, double within, bench *b)
{
    *b = (bench){.freedom = {0}};
    memcpy(b->z, z, (size_t)(width * N) * sizeof *z);
    for (int i = 0; i < N; i++) {
        b->freedom[i] = i == 0 || i == N - 1 ? 0 : width;
        b->within[i] = b->freedom[i] > 0 ? within : 0;
        for (int k = 0; k < width; k++)
            b->frames[(i * width + k) * width + k] = 1;
    }
    b->piece.batten = &b->batten;
    b->piece.ducks = (bat_ducks){.width = width,
                                 .centre = b->z,
                                 .within = b->within,
                                 .freedom = b->freedom,
                                 .frames = b->frames};
    batten_status status = bat_batten_begin(N, t, &b->batten);
    if (status != BATTEN_OK)
        return status;
    status = bat_change_begin(&b->piece, &b->change);
    if (status != BATTEN_OK) {
        bat_arena_free(&b->change.arena);
        bat_batten_end(&b->batten);
    }
    return status;
}

static void end_bench(bench *b)
{
    bat_arena_free(&b->change.arena);
    bat_batten_end(&b->batten);
}

static const double wave[2 * N] = {0, 0.2, 1.1, 0.9, 1.4, 0.1, 3.2, -0.5, 3.9, 0.4, 6, 0.3};

TEST(it_begins_with_the_knots_of_the_ducks_and_the_largest_bound)
{
    bench b;
    CHECK_OK(begin_bench(1, wave, 0.3, &b));
    CHECK(b.change.ducks == N && b.change.width == 1 && b.change.unit == 0.3);
    for (int i = 0; i < N + 6; i++)
        CHECK(b.change.knots[i] == t[i < 3 ? 0 : i - 3 < N ? i - 3 : N - 1]);
    end_bench(&b);
}

/* The Bezier points of P' on a span are P' at its ends and, between them, half a span of P'' beyond the first. */
TEST(turning_and_bending_are_those_of_the_curve)
{
    for (int width = 1; width <= 2; width++) {
        bench b;
        batten_curve *curve = NULL;
        double turning[N];
        CHECK_OK(begin_bench(width, wave, 0.3, &b));
        CHECK_OK(bat_batten_curve(&b.batten, width, wave, &curve));
        bat_change_bend(&b.change, wave);
        bat_change_turning(&b.change, turning);
        for (int i = 0; i < N; i++) {
            double at[6], next[6], expected;
            CHECK_OK(batten_curve_evaluate(curve, t[i], 2, at));
            const double *d = at + width, *dd = at + 2 * width;
            expected = width == 1 ? dd[0] : d[0] * dd[1] - d[1] * dd[0];
            CHECK_NEAR(turning[i], i == 0 || i == N - 1 ? 0 : expected, 1e-12);
            for (int k = 0; k < width; k++)
                CHECK_NEAR(b.change.moments[width * i + k], dd[k], 1e-12);
            if (i == N - 1)
                continue;
            CHECK_OK(batten_curve_evaluate(curve, t[i + 1], 2, next));
            for (int k = 0; k < width; k++) {
                const double *h = b.change.bend + 3 * width * i + k;
                CHECK_NEAR(h[0], d[k], 1e-12);
                CHECK_NEAR(h[width], d[k] + (t[i + 1] - t[i]) / 2 * dd[k], 1e-12);
                CHECK_NEAR(h[2 * width], next[width + k], 1e-12);
            }
        }
        batten_curve_unref(curve);
        end_bench(&b);
    }
}

/* With the signs that it has a batten that is off goes back to where it was given. */
TEST(a_step_with_signs_that_hold_goes_to_the_given_places)
{
    for (int width = 1; width <= 2; width++) {
        bench b;
        double z[2 * N], turning[N], length = -1, farthest = 0;
        CHECK_OK(begin_bench(width, wave, 0.3, &b));
        bat_change_bend(&b.change, wave);
        bat_change_turning(&b.change, turning);
        for (int i = 0; i < N; i++) /* those at the ends are of the next ducks */
            b.change.signs[i] = turning[i == 0 ? 1 : i == N - 1 ? N - 2 : i] > 0 ? 1 : -1;
        memcpy(z, wave, sizeof z);
        for (int i = width; i < (N - 1) * width; i++) {
            z[i] += i % 2 ? 0.01 : -0.004;
            farthest = fmax(farthest, fabs(z[i] - wave[i]));
        }
        CHECK_OK(bat_change_step(&b.change, z, &length));
        CHECK_NEAR(length, farthest / 0.3, 1e-5);
        for (int i = 0; i < width * N; i++)
            CHECK_NEAR(z[i], wave[i], 1e-6);
        end_bench(&b);
    }
}

/* The other way round: no sign may be met within the bounds, which all ducks keep. */
TEST(a_step_keeps_the_bounds_whatever_the_signs)
{
    for (int width = 1; width <= 2; width++)
        for (int sign = -1; sign <= 1; sign += 2) {
            bench b;
            double z[2 * N], length;
            CHECK_OK(begin_bench(width, wave, 0.05, &b));
            for (int i = 0; i < N; i++)
                b.change.signs[i] = sign;
            memcpy(z, wave, sizeof z);
            CHECK_OK(bat_change_step(&b.change, z, &length));
            CHECK(length > 0.9 && length <= 1);
            for (int i = 0; i < N; i++)
                CHECK(bat_distance(width, z + width * i, wave + width * i) <=
                      (b.freedom[i] > 0 ? 0.05 : 1e-8));
            end_bench(&b);
        }
}
