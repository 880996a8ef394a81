#include "design/text/document.h"

#include "support/test.h"

/* Random needs among things of smaller index, shuffled by a fixed rule, have no ring. */
TEST(each_thing_comes_after_what_it_needs)
{
    test_random random = test_random_begin("graph");
    for (int test = 0; test < test_cases(50); test++) {
        const int count = test_random_int(&random, 1, 60);
        int begin[61], needs[600], order[60], place[60], cycle[61], used = 0;
        for (int i = 0; i < count; i++) {
            begin[i] = used;
            for (int k = 0; k < 5 && i > 0;
                 k++) /* things of larger index need smaller ones, reversed */
                if (test_random_unit(&random) < 0.5)
                    needs[used++] = test_random_int(&random, 0, i - 1);
        }
        begin[count] = used;
        const bat_graph graph = {count, begin, needs};
        int ring = bat_graph_order(&graph, order, cycle);
        if (ring < 0)
            ring = bat_graph_order(&graph, order, cycle);
        if (ring < 0)
            return;
        CHECK_INT(ring, 0);
        for (int i = 0; i < count; i++)
            place[order[i]] = i;
        for (int i = 0; i < count; i++)
            for (int k = begin[i]; k < begin[i + 1]; k++)
                CHECK(place[needs[k]] < place[i]);
    }
}

TEST(a_ring_is_shown_with_its_members_in_order)
{
    int begin[] = {0, 1, 2, 3, 3}, needs[] = {1, 2, 1}; /* 0 -> 1 -> 2 -> 1 */
    const bat_graph graph = {4, begin, needs};
    int order[4], cycle[5];
    int ring = bat_graph_order(&graph, order, cycle);
    if (ring < 0)
        ring = bat_graph_order(&graph, order, cycle);
    if (ring < 0)
        return;
    CHECK_INT(ring, 2);
    CHECK_INT(cycle[0], 1);
    CHECK_INT(cycle[1], 2);
    CHECK_INT(cycle[2], 1);
}

TEST(S4_a_chain_of_a_hundred_thousand_needs_no_deep_stack)
{
    const int count = 100000;
    int *begin = test_array(count + 1, sizeof *begin),
        *needs = test_array(count, sizeof *needs);
    int *order = test_array(count, sizeof *order),
        *cycle = test_array(count + 1, sizeof *cycle);
    bool *marked = test_array(count, sizeof *marked);
    for (int i = 0; i < count; i++) {
        begin[i] = i;
        needs[i] = i + 1;
    }
    begin[count] = count - 1; /* the last needs nothing */
    const bat_graph graph = {count, begin, needs};
    int ring = bat_graph_order(&graph, order, cycle);
    if (ring < 0)
        ring = bat_graph_order(&graph, order, cycle);
    if (ring < 0)
        return;
    CHECK_INT(ring, 0);
    CHECK_INT(order[0], count - 1);
    CHECK_OK(bat_graph_mark(&graph, count / 2, marked));
    CHECK(!marked[0] && marked[count / 2] && marked[count - 1]);
}
