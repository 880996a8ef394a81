#include "fair/least_change.h"
#include "support/test.h"

enum { MOST = 9 };

static const double all[MOST] = {0, 1, 1.5, 3, 4, 6, 6.5, 7.25, 9};

/* What the rows need: the ducks and the knots, each end four times. */
typedef struct {
    bat_batten batten;
    bat_fair_piece piece;
    double knots[MOST + 6];
    bat_least_change change;
} bench;

static void begin_bench(int ducks, bench *b)
{
    *b = (bench){.batten = {.count = ducks, .t = all}};
    b->piece.batten = &b->batten;
    for (int i = 0; i < ducks + 6; i++)
        b->knots[i] = all[i < 3 ? 0 : i - 3 < ducks ? i - 3 : ducks - 1];
    b->change =
        (bat_least_change){.piece = &b->piece, .ducks = ducks, .width = 1, .knots = b->knots};
}

static double value_of(const bat_change_row *row, const double *x)
{
    double sum = 0;
    for (int k = 0; k < BAT_CHANGE_SUPPORT; k++)
        sum += row->weight[k] * x[row->first + k];
    return sum;
}

TEST(rows_at_a_duck_are_those_of_both_spans_beside_it)
{
    for (int ducks = 4; ducks <= MOST; ducks++) {
        bench b;
        begin_bench(ducks, &b);
        for (int unknown = 0; unknown < ducks; unknown++) {
            double x[MOST] = {0};
            x[unknown] = 1;
            for (int i = 0; i < ducks; i++)
                for (int order = 0; order <= 2; order++) {
                    const bat_change_row at = bat_change_row_at(&b.change, i, order);
                    CHECK(at.first >= 0 && at.first + BAT_CHANGE_SUPPORT <= ducks);
                    for (int side = 0; side < 2; side++) {
                        const int span = i - side;
                        if (span < 0 || span > ducks - 2)
                            continue;
                        const bat_change_row on =
                            bat_change_row_on(&b.change, span, side == 1, order);
                        CHECK_NEAR(value_of(&on, x), value_of(&at, x), 1e-12);
                    }
                }
        }
    }
}

/* Unknown j is coefficient j + 1 of the cubic B-splines; of t that is the mean of its three knots, at the ends the end. */
TEST(a_linear_difference_is_exact_and_does_not_bend)
{
    for (int ducks = 4; ducks <= MOST; ducks++) {
        bench b;
        double x[MOST];
        begin_bench(ducks, &b);
        for (int j = 0; j < ducks; j++)
            x[j] = j == 0           ? all[0]
                   : j == ducks - 1 ? all[ducks - 1]
                                    : (b.knots[j + 2] + b.knots[j + 3] + b.knots[j + 4]) / 3;
        for (int i = 0; i < ducks; i++) {
            const bat_change_row value = bat_change_row_at(&b.change, i, 0),
                                 slope = bat_change_row_at(&b.change, i, 1),
                                 bend = bat_change_row_at(&b.change, i, 2);
            CHECK_NEAR(value_of(&value, x), all[i], 1e-14);
            CHECK_NEAR(value_of(&slope, x), 1, 1e-13);
            CHECK_NEAR(value_of(&bend, x), 0, 1e-12);
        }
    }
}

TEST(no_difference_bends_at_its_ends)
{
    for (int ducks = 4; ducks <= MOST; ducks++) {
        bench b;
        begin_bench(ducks, &b);
        for (int unknown = 0; unknown < ducks; unknown++) {
            double x[MOST] = {0};
            x[unknown] = 1;
            const bat_change_row first = bat_change_row_at(&b.change, 0, 2),
                                 last = bat_change_row_at(&b.change, ducks - 1, 2);
            CHECK_NEAR(value_of(&first, x), 0, 1e-13);
            CHECK_NEAR(value_of(&last, x), 0, 1e-12);
        }
    }
}
