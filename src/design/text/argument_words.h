/* Arguments that are names, words and files. */
#ifndef BAT_DESIGN_TEXT_ARGUMENT_WORDS_H
#define BAT_DESIGN_TEXT_ARGUMENT_WORDS_H
#include "design/text/document.h"

/* What is being read, for the sentences about it. */
typedef struct {
    bat_document *document;
    const bat_entry *entry;
    const batten_parameter *parameter;
    int at; /* the node to which complaints point */
} bat_reading;

void bat_complain_of(const bat_reading *r, const char *what);
void bat_read_model(const bat_reading *r, const char *word, bat_item *item);
void bat_read_word(const bat_reading *r, const char *given, bat_item *item);
void bat_read_yes_no(const bat_reading *r, const char *word, bat_item *item);
void bat_read_file(const bat_reading *r, const char *word, bat_item *item);

#endif
