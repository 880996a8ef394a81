/* Groups within groups: in which order they are entered, filled and left. */
#include "model/groups.h"
#include "support/test.h"

typedef struct {
    char said[4000];
    int left; /* how many calls succeed; below 0: all */
} story;

static batten_status tell(story *s, const char *text)
{
    if (s->left == 0)
        return BATTEN_CANCELLED;
    s->left--;
    strcat(s->said, text);
    return BATTEN_OK;
}

static batten_status enter(void *context, int depth, const char *name)
{
    char text[400];
    snprintf(text, sizeof text, "%d(%s ", depth, name);
    return tell(context, text);
}

static batten_status take_items(void *context, int depth, const bat_member *members, int count)
{
    char text[200];
    int at = snprintf(text, sizeof text, "%d:", depth);
    for (int i = 0; i < count; i++)
        at += snprintf(text + at, sizeof text - (size_t)at, "%d,", members[i].item);
    return tell(context, text);
}

static batten_status leave(void *context, int depth)
{
    char text[20];
    snprintf(text, sizeof text, "%d) ", depth);
    return tell(context, text);
}

/* What a visit of these paths reports; their items are numbered in their order. */
static batten_status visit(int count, const char *const *paths, story *s)
{
    bat_members list = {0};
    const bat_group_visitor visitor = {s, enter, take_items, leave};
    s->said[0] = '\0';
    for (int i = 0; i < count; i++)
        CHECK_OK(bat_members_add(&list, paths[i], i));
    const batten_status status = bat_groups_visit(&list, &visitor);
    bat_members_end(&list);
    return status;
}

static const struct {
    const char *paths[5], *told;
} cases[] = {
    {{"a"}, "0(a 0:0,0) "},
    {{"b", "a", "a"}, "0(a 0:1,2,0) 0(b 0:0,0) "},
    {{"a/b", "a"}, "0(a 0:1,1(b 1:0,1) 0) "},
    {{"a/b/c"}, "0(a 1(b 2(c 2:0,2) 1) 0) "},
    {{"a/b", "a/c", "d"}, "0(a 1(b 1:0,1) 1(c 1:1,1) 0) 0(d 0:2,0) "},
    /* a name that goes on as another does is another */
    {{"a", "ab", "a/b"}, "0(a 0:0,1(b 1:2,1) 0) 0(ab 0:1,0) "},
    {{"ab/c", "a/c"}, "0(a 1(c 1:1,1) 0) 0(ab 1(c 1:0,1) 0) "},
    {{"a/b/c", "a/b", "a/bc", "a"}, "0(a 0:3,1(b 1:1,2(c 2:0,2) 1) 1(bc 1:2,1) 0) "},
};

TEST(a_group_is_entered_filled_and_left_before_the_next_beside_it)
{
    for (int i = 0; i < COUNT(cases); i++) {
        story s = {.left = -1};
        int count = 0;
        while (count < 5 && cases[i].paths[count])
            count++;
        CHECK_STATUS(visit(count, cases[i].paths, &s), BATTEN_OK);
        CHECK_TEXT(s.said, cases[i].told);
    }
}

TEST(a_visit_ends_with_the_first_failure_of_its_visitor)
{
    static const char *const paths[] = {"a/b", "a/c"};
    story s = {.left = -1};
    if (test_cases(1000) < 1000)
        SKIP("calls are counted, and made twice where memory fails");
    CHECK_OK(visit(2, paths, &s)); /* enter a, b, items, leave b, enter c, items, leave c, a */
    for (int left = 0; left < 8; left++) {
        story part = {.left = left};
        CHECK_STATUS(visit(2, paths, &part), BATTEN_CANCELLED);
        CHECK(strncmp(part.said, s.said, strlen(part.said)) == 0);
        CHECK_INT(part.left, 0);
    }
    story all = {.left = 8};
    CHECK_OK(visit(2, paths, &all));
}

/* Of 70 names the last seven are one. */
TEST(below_the_deepest_group_the_rest_of_a_path_is_one_name)
{
    char path[400] = "g0", last[80] = "g63";
    const char *const paths[] = {path};
    story s = {.left = -1};
    for (int i = 1; i < 70; i++)
        sprintf(path + strlen(path), "/g%d", i);
    for (int i = 64; i < 70; i++)
        sprintf(last + strlen(last), "/g%d", i);
    strcat(last, " 63:0,63) ");
    CHECK_OK(visit(1, paths, &s));
    CHECK_CONTAINS(s.said, "62(g62 63(");
    CHECK_CONTAINS(s.said, last);
    CHECK(strstr(s.said, "64(") == NULL);
}

TEST(members_are_found_by_their_path_and_counted)
{
    static const char *const paths[] = {"b", "a", "b", "a/c", "b"};
    bat_members list = {0};
    for (int i = 0; i < COUNT(paths); i++)
        CHECK_OK(bat_members_add(&list, paths[i], i));
    bat_members_sort(&list);
    const bat_member *b = bat_members_find(&list, "b");
    CHECK_INT(b - list.members, 2);
    CHECK_INT(b->item, 0);
    CHECK_INT(bat_members_same(&list, 2), 3);
    CHECK_INT(bat_members_same(&list, 3), 2);
    CHECK_INT(bat_members_same(&list, 0), 1);
    CHECK_INT(bat_members_find(&list, "a/c")->item, 3);
    CHECK_INT(bat_members_find(&list, "a")->item, 1);
    bat_members_end(&list);
}
