/* The head of a design: version, units, tolerance and title. */
#include "design/text/document.h"
#include "design/text/spelling.h"

#include <string.h>

static const char *const sections[] = {"batten",       "units",      "tolerance", "title",
                                       "most-objects", "parameters", "features",  "outputs"};
#define SECTION_COUNT ((int)(sizeof sections / sizeof sections[0]))

static void check_sections(bat_document *d)
{
    const bat_node *nodes = d->tree.nodes;
    for (int i = nodes[0].first; i >= 0; i = nodes[i].next) {
        const char *word = nodes[nodes[i].key].word;
        int known = 0, best = 99;
        while (known < SECTION_COUNT && strcmp(word, sections[known]) != 0)
            known++;
        if (known < SECTION_COUNT)
            continue;
        const char *near = NULL;
        for (int k = 0; k < SECTION_COUNT; k++)
            if (bat_is_nearer(word, sections[k], &best))
                near = sections[k];
        bat_complain(d, nodes[i].key, "a design has no section '%s'%s%s%s", word,
                     near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
    }
}

/* The word of a section, or NULL: absent, or not a word, which is reported. */
static const char *head_word(bat_document *d, const char *section, int *node)
{
    *node = bat_tree_find(&d->tree, 0, section);
    if (*node < 0)
        return NULL;
    const bat_node *at = &d->tree.nodes[*node];
    if (at->kind == BAT_NODE_WORD && *at->word)
        return at->word;
    bat_complain(d, *node, "'%s' needs a value", section);
    return NULL;
}

static void read_version(bat_document *d)
{
    int node, version = 0;
    const char *word = head_word(d, "batten", &node);
    if (node < 0)
        bat_complain(d, 0, "the line 'batten: %d', the version of the format, is missing",
                     BAT_FORMAT_VERSION);
    if (!word)
        return;
    if (bat_count_read(word, &version) != BATTEN_OK)
        bat_complain(d, node, "the version of the format: %s", batten_message());
    else if (version > BAT_FORMAT_VERSION)
        bat_complain(d, node, "the format has version %d; this Batten knows up to %d", version,
                     BAT_FORMAT_VERSION);
    else if (version < 1)
        bat_complain(d, node, "the format has no version %d; the first is 1", version);
}

void bat_tolerance_read(bat_document *d)
{
    int node;
    const char *word = head_word(d, "tolerance", &node);
    /* A tenth of a millimetre: finer than plates are cut, coarser than files round. */
    d->tolerance = 1e-4 / d->unit_metres;
    if (!word)
        return;
    const bat_names names = bat_document_names(d);
    bat_quantity value;
    char text[48];
    if (bat_quantity_read(word, &names, NULL, &value) != BATTEN_OK)
        bat_complain(d, node, "%s", batten_message());
    else if (value.angle || value.length > 1 || value.length < 0)
        bat_complain(d, node, "the tolerance must be a length, not %s",
                     bat_dimension_name(value.length, value.angle, text));
    else if (value.value <= 0)
        bat_complain(d, node, "the tolerance must be above 0, not %s", word);
    else
        d->tolerance = value.value;
}

static void read_units(bat_document *d)
{
    int node;
    d->unit_metres = 1;
    const char *word = head_word(d, "units", &node);
    d->has_units = word != NULL;
    if (!word)
        return;
    const double metres = batten_unit_metres(word);
    if (metres > 0)
        d->unit_metres = metres;
    else
        bat_complain(d, node,
                     "unknown unit of length '%s'; known are m mm cm km um in ft mil mi", word);
}

/* More would fill the memory of a small machine: an object takes about 700 bytes and what it holds. */
enum { MOST_OBJECTS = 1000000 };

static void read_most_objects(bat_document *d)
{
    int node, most = 0;
    const char *word = head_word(d, "most-objects", &node);
    d->most_objects = MOST_OBJECTS;
    if (!word)
        return;
    if (bat_count_read(word, &most) != BATTEN_OK)
        bat_complain(d, node, "the most objects that the design may make: %s",
                     batten_message());
    else if (most < 1)
        bat_complain(d, node, "'most-objects' must be 1 or more, not %d", most);
    else
        d->most_objects = most;
}

void bat_head_read(bat_document *d)
{
    int node;
    read_version(d);
    check_sections(d);
    read_units(d);
    read_most_objects(d);
    d->title = head_word(d, "title", &node);
}
