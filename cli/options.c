/* The words of a command line, sorted into options, values and files. */
#include "options.h"

#include "complain.h"

#include <batten/text.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int find(const arguments *read, const char *name, size_t length)
{
    for (int i = 0; i < read->option_count; i++)
        if (strlen(read->options[i].name) == length &&
            strncmp(read->options[i].name, name, length) == 0)
            return i;
    return -1;
}

static int find_letter(const arguments *read, char letter)
{
    for (int i = 0; i < read->option_count; i++)
        if (letter && read->options[i].letter == letter)
            return i;
    return -1;
}

static bool unknown(const char *command, const arguments *read, const char *word)
{
    const char *names[128];
    int count = 0;
    for (int i = 0; i < read->option_count && count < 128; i++)
        names[count++] = read->options[i].name;
    const char *near = nearest_name(word + strspn(word, "-"), count, names);
    complain("batten %s: there is no option %s%s%s; see 'batten help %s'", command, word,
             near ? "; did you mean --" : "", near ? near : "", command);
    return false;
}

static bool keep_option(const char *command, arguments *read, int index, const char *value)
{
    const option *found = &read->options[index];
    if (found->kind != OPTION_MANY && arguments_get(read, found->name)) {
        complain("batten %s: --%s is given twice", command, found->name);
        return false;
    }
    read->given[read->given_count++] = (struct given){index, value};
    return true;
}

/* Is the word one of the options? Then it is not the value of another. "-3mm" is not. */
static bool is_option(const arguments *read, const char *word)
{
    const bool is_long = word[0] == '-' && word[1] == '-';
    return is_long ? find(read, word + 2, strcspn(word + 2, "=")) >= 0
                   : word[0] == '-' && strlen(word) == 2 && find_letter(read, word[1]) >= 0;
}

/* One word that begins with '-'; `next` is the word behind it, taken when `*taken` becomes
 * true. */
static bool read_option(const char *command, arguments *read, const char *word,
                        const char *next, bool *taken)
{
    const bool is_long = word[1] == '-';
    const char *name = word + (is_long ? 2 : 1);
    const char *equals = is_long ? strchr(name, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const int index = is_long ? find(read, name, length) : find_letter(read, name[0]);
    if (index < 0)
        return unknown(command, read, word);

    const char *attached = equals ? equals + 1 : !is_long && name[1] ? name + 1 : NULL;
    if (read->options[index].kind == OPTION_FLAG) {
        if (!attached)
            return keep_option(command, read, index, "");
        complain("batten %s: --%s takes no value", command, read->options[index].name);
        return false;
    }
    if (read->options[index].kind == OPTION_SWITCH)
        return keep_option(command, read, index, attached ? attached : "yes");
    *taken = !attached;
    if (!attached && (!next || is_option(read, next))) {
        complain("batten %s: --%s needs a value: %s", command, read->options[index].name,
                 read->options[index].value);
        return false;
    }
    return keep_option(command, read, index, attached ? attached : next);
}

static bool read_words(const char *command, int most, int count, char **words, arguments *read)
{
    bool options_end = false;
    for (int i = 0; i < count; i++) {
        if (!options_end && strcmp(words[i], "--") == 0) {
            options_end = true;
        } else if (!options_end && words[i][0] == '-' && words[i][1]) {
            bool taken = false;
            if (!read_option(command, read, words[i], i + 1 < count ? words[i + 1] : NULL,
                             &taken))
                return false;
            i += taken;
        } else if (read->file_count == most) {
            complain("batten %s: '%s' is one word too many; see 'batten help %s'", command,
                     words[i], command);
            return false;
        } else {
            read->files[read->file_count++] = words[i];
        }
    }
    return true;
}

bool arguments_read(const char *command, int option_count, const option *options, int least,
                    int most, int count, char **words, arguments *out)
{
    arguments read = {.option_count = option_count, .options = options};
    read.given = batten_array((size_t)count, sizeof *read.given);
    read.files = batten_array((size_t)count, sizeof *read.files);
    bool good = read.given && read.files;
    if (!good)
        complain("batten %s: %s", command, batten_message());
    good = good && read_words(command, most, count, words, &read);
    if (good && read.file_count < least && !arguments_has(&read, "help")) {
        complain("batten %s: %s; see 'batten help %s'", command,
                 read.file_count == 0 ? "a file is missing" : "another file is missing",
                 command);
        good = false;
    }
    if (!good) {
        arguments_free(&read);
        return false;
    }
    *out = read;
    return true;
}

void arguments_free(arguments *read)
{
    batten_release(read->given);
    batten_release(read->files);
    *read = (arguments){0};
}

const char *arguments_get(const arguments *read, const char *name)
{
    for (int i = 0; i < read->given_count; i++)
        if (strcmp(read->options[read->given[i].option].name, name) == 0)
            return read->given[i].value;
    return NULL;
}

bool arguments_has(const arguments *read, const char *name)
{
    return arguments_get(read, name) != NULL;
}

bool arguments_word(const arguments *read, const char *name, int count,
                    const char *const *words, int *index)
{
    const char *word = arguments_get(read, name);
    for (int k = 0; word && k < count; k++)
        if (strcmp(word, words[k]) == 0) {
            *index = k;
            return true;
        }
    return !word;
}

bool arguments_number(const char *command, const arguments *read, const char *name,
                      double *value)
{
    const char *text = arguments_get(read, name);
    if (!text)
        return true;
    if (batten_number_read(text, strlen(text), value, NULL) == BATTEN_OK)
        return true;
    complain("batten %s: --%s wants a number, not '%s'", command, name, text);
    return false;
}

bool arguments_count(const char *command, const arguments *read, const char *name, int least,
                     int most, int *value)
{
    double number = *value;
    if (!arguments_number(command, read, name, &number))
        return false;
    if (number < least || number > most || number != floor(number)) {
        complain("batten %s: --%s wants a whole number from %d to %d, not '%s'", command, name,
                 least, most, arguments_get(read, name));
        return false;
    }
    *value = (int)number;
    return true;
}
