/* Options of a command as values of a design: quoted, listed, checked by the table of features. */
#include "values.h"

#include <string.h>

size_t value_span(const char *text, const char *stops)
{
    int depth = 0;
    size_t i = 0;
    for (; text[i] && (depth > 0 || !strchr(stops, text[i])); i++) {
        depth += text[i] == '[' || text[i] == '(';
        depth -= depth > 0 && (text[i] == ']' || text[i] == ')');
    }
    return i;
}

/* Is the whole text one list? Its bracket must not close before the end: what would follow
 * could be anything of a design. */
static bool is_list(const char *text)
{
    const size_t length = strlen(text);
    int depth = *text == '[';
    size_t i = 1;
    for (; depth > 0 && i < length; i++)
        depth += (text[i] == '[') - (text[i] == ']');
    return length > 1 && depth == 0 && i == length && text[i - 1] == ']';
}

static bool has_coordinates(const batten_parameter *p)
{
    return p->kind == BATTEN_VALUE_POINT || p->kind == BATTEN_VALUE_RANGE ||
           p->kind == BATTEN_VALUE_POINTS || p->kind == BATTEN_VALUE_MOVE;
}

/* Do commas part values, or can they belong to a name or a text? */
static bool takes_commas(const batten_parameter *p)
{
    const bool is_text = p->kind == BATTEN_VALUE_TEXT || p->kind == BATTEN_VALUE_FILE ||
                         p->kind == BATTEN_VALUE_MODEL;
    return has_coordinates(p) || (p->is_list && !is_text);
}

/* A list without its brackets, when its items are as much as the value itself. */
static void add_items(batten_text *text, const batten_parameter *p, const char *list)
{
    const bool is_one = has_coordinates(p) && !strchr(list + 1, '[');
    if (is_one)
        batten_text_add(text, "%s", list);
    else
        batten_text_bytes(text, list + 1, strlen(list) - 2);
}

/* Add what one option gives; true when it is a list. */
static bool add_value(batten_text *text, const batten_parameter *p, const char *value)
{
    batten_text list = BATTEN_TEXT;
    if (*value == '[')
        batten_text_add(&list, "%s", value);
    else if (takes_commas(p) && value[value_span(value, ",")])
        batten_text_add(&list, "[%s]", value);
    const bool listed = list.bytes && is_list(list.bytes) && (has_coordinates(p) || p->is_list);
    if (listed)
        add_items(text, p, list.bytes);
    else
        batten_text_json(text, value);
    text->failed |= list.failed;
    batten_text_free(&list);
    return listed;
}

void values_add(batten_text *text, const arguments *given, const batten_parameter *parameter)
{
    batten_text items = BATTEN_TEXT;
    bool listed = false;
    int count = 0;
    for (int i = 0; i < given->given_count; i++) {
        if (strcmp(given->options[given->given[i].option].name, parameter->name) != 0)
            continue;
        batten_text_add(&items, "%s", count++ ? ", " : "");
        listed |= add_value(&items, parameter, given->given[i].value);
    }
    const bool many = parameter->is_list && (listed || count > 1);
    if (count && !items.failed)
        batten_text_add(text, many ? ", %s: [%s]" : ", %s: %s", parameter->name, items.bytes);
    text->failed |= items.failed;
    batten_text_free(&items);
}
