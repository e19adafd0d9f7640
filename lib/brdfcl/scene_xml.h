/*
 * scene_xml.h - an XML file as a tree of elements that remember where they stand.
 */
#ifndef BRDFCL_LIB_SCENE_XML_H
#define BRDFCL_LIB_SCENE_XML_H

#include <stddef.h>

#include <brdf/status.h>

struct xml_attribute {
    const char *name;
    const char *value;
};

struct xml_node {
    const char *tag;
    struct xml_attribute *attributes;
    int attribute_count;
    int line; /* of the '<', from 1 */
    int column;
    struct xml_node *parent;
    struct xml_node *child; /* the first one */
    struct xml_node *last;  /* the last one */
    struct xml_node *next;  /* of the same parent */
    int visit;              /* for walks: 0 not seen, 1 on the way, 2 done */
    void *product;          /* what the loader has made of it */
    void *twosided_product; /* the same, of a bsdf inside of a twosided */
};

struct xml_document {
    const char *path;
    struct xml_node *root;
    struct xml_block *blocks; /* every string and node; freed together */
};

/* Read a file. The path is kept, not copied; errors name file, line and column. The document is to
   be freed whether or not this succeeds. */
brdf_status xml_document_read(const char *path, struct xml_document *document,
                              struct brdf_error *error);
void xml_document_free(struct xml_document *document);

/* Memory (zeroed) and strings that live as long as the document; NULL if there is none left. */
void *xml_allocate(struct xml_document *document, size_t size);
const char *xml_copy(struct xml_document *document, const char *text, size_t length);

/* The value of an attribute, NULL if it is not there. */
const char *xml_attribute_get(const struct xml_node *node, const char *name);

#endif
