#include "shape/network/networks.h"

static batten_curve *line(double ax, double ay, double az, double bx, double by, double bz)
{
    const double points[] = {ax, ay, az, bx, by, bz}, knots[] = {0, 0, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    return curve;
}

static void end(int count, batten_curve **curves)
{
    for (int k = 0; k < count; k++)
        batten_curve_unref(curves[k]);
}

static batten_status split(int count, batten_curve **curves, int *family)
{
    return batten_network_split(count, (const batten_curve *const *)curves, 1e-3, NULL, NULL,
                                family);
}

TEST(G7_a_mixed_list_is_split_by_what_crosses_what)
{
    network n = network_on(shell, 4, 3, 20, 0.3);
    batten_curve *all[7] = {n.curves[1][2], n.curves[0][1], n.curves[0][3], n.curves[1][0],
                            n.curves[0][0], n.curves[1][1], n.curves[0][2]};
    const int wanted[7] = {0, 1, 1, 0, 1, 0, 1};
    int family[7];
    CHECK_OK(split(7, all, family));
    for (int k = 0; k < 7; k++)
        CHECK_INT(family[k], wanted[k]);
    network_end(&n);
}

/* The rim alone: four curves that meet in corners. */
TEST(four_curves_round_a_patch_are_two_families)
{
    network n = network_on(shell, 2, 2, 20, 0);
    batten_curve *all[4] = {n.curves[0][0], n.curves[1][1], n.curves[1][0], n.curves[0][1]};
    int family[4];
    CHECK_OK(split(4, all, family));
    CHECK(family[0] == 0 && family[1] == 1 && family[2] == 1 && family[3] == 0);
    network_end(&n);
}

TEST(curves_that_share_a_pole_are_one_family)
{
    batten_curve *all[7];
    int family[7];
    for (int k = 0; k < 5; k++)
        all[k] = draw(globe, (drawn){1, k / 5.0, 0, 1, 0, 40});
    for (int k = 5; k < 7; k++)
        all[k] = draw(globe, (drawn){0, k / 10.0, 0.1, 1.1, 0, 40});
    CHECK_OK(split(7, all, family));
    for (int k = 0; k < 7; k++)
        CHECK_INT(family[k], k >= 5);
    end(7, all);
}

TEST(a_curve_that_meets_none_is_named_with_its_nearest)
{
    batten_curve *all[] = {line(0, 0, 0, 3, 0, 0), line(0, 1, 0, 3, 1, 0),
                           line(1, -1, 0, 1, 2, 0), line(2, -1, 0.12, 2, 2, 0.12)};
    const char *names[] = {"keel", "chine", "rib 1", "rib 2"};
    int family[4];
    CHECK_STATUS(
        batten_network_split(4, (const batten_curve *const *)all, 1e-3, names, NULL, family),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "'rib 2' (4 of 4) meets no other curve; 'keel' (1 of 4) is nearest, 0.12 away");
    end(4, all);
}

TEST(three_curves_that_all_cross_are_refused)
{
    batten_curve *all[] = {line(0, 0, 0, 3, 0, 0), line(1, -1, 0, 1, 2, 0),
                           line(0, -1, 0, 3, 2, 0)};
    int family[3];
    CHECK_STATUS(split(3, all, family), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("they are of one family");
    end(3, all);
}

TEST(two_networks_in_one_list_are_refused)
{
    batten_curve *all[] = {line(0, 0, 0, 3, 0, 0), line(1, -1, 0, 1, 2, 0),
                           line(0, 0, 5, 3, 0, 5), line(1, -1, 5, 1, 2, 5)};
    int family[4];
    CHECK_STATUS(split(4, all, family), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("two networks");
    end(4, all);
}

static const struct {
    int count;
    double tolerance;
    batten_status status;
    const char *message;
} refused[] = {
    {2, NAN, BATTEN_NOT_FINITE, "the tolerance is nan"},
    {2, 0, BATTEN_BAD_ARGUMENT, "the tolerance is 0, not above 0"},
    {2, -2, BATTEN_BAD_ARGUMENT, "the tolerance is -2, not above 0"},
    {1, 1e-3, BATTEN_TOO_FEW_POINTS, "there is 1 curve; a network has 2 or more"},
    {0, 1e-3, BATTEN_TOO_FEW_POINTS, "there are 0 curves; a network has 2 or more"},
    {1001, 1e-3, BATTEN_TOO_LARGE,
     "there are 1001 curves in one list; the limit is 1000: give profiles and guides apart"},
};

TEST(lists_that_are_no_network_are_named_with_their_numbers)
{
    static batten_curve *all[1001];
    batten_curve *one = line(0, 0, 0, 3, 0, 0);
    static int family[1001];
    for (int k = 0; k < COUNT(all); k++)
        all[k] = one;
    for (int i = 0; i < COUNT(refused); i++) {
        CHECK_STATUS(batten_network_split(refused[i].count, (const batten_curve *const *)all,
                                          refused[i].tolerance, NULL, NULL, family),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    batten_curve_unref(one);
}
