#include "content/import/collection/iiif.h"

#include <algorithm>
#include <array>

#include "content/content_error.h"
#include "content/import/collection/plain_text.h"
#include "content/import/floor/json.h"

namespace docent::import {

namespace {

using Kind = JsonValue::Kind;
using Texts = std::map<std::string, std::string, std::less<>>;

constexpr const char* undetermined = "und";

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::string language_of(const std::string& tag) {
  return tag.empty() || tag == "none" || tag == "@none" ? undetermined : tag;
}

void add_text(Texts& texts, const std::string& language, const std::string& value) {
  const std::string text = plain_text(value);
  if (text.empty()) return;
  std::string& joined = texts[language_of(language)];
  joined += (joined.empty() ? "" : " | ") + text;
}

/// A value of version 2: a text, {"@value", "@language"}, or a list of them.
void add_texts_of_2(Texts& texts, const JsonValue& value) {
  if (value.kind == Kind::String) return add_text(texts, {}, value.string);
  if (value.kind == Kind::Array)
    for (const JsonValue& item : value.items) add_texts_of_2(texts, item);
  if (value.kind != Kind::Object) return;
  const JsonValue* text = find_member(value, "@value");
  const JsonValue* language = find_member(value, "@language");
  if (text != nullptr && text->kind == Kind::String)
    add_text(texts, language != nullptr ? language->string : std::string(), text->string);
}

/// A value of version 3: lists of texts by language; what version 2 wrote is understood, too.
Texts texts_of(const JsonValue* value) {
  Texts texts;
  if (value == nullptr) return texts;
  if (value->kind != Kind::Object || find_member(*value, "@value") != nullptr) {
    add_texts_of_2(texts, *value);
    return texts;
  }
  for (std::size_t i = 0; i < value->items.size() && i < value->names.size(); ++i) {
    const JsonValue& items = value->items[i];
    if (items.kind == Kind::String) add_text(texts, value->names[i], items.string);
    if (items.kind == Kind::Array)
      for (const JsonValue& item : items.items)
        if (item.kind == Kind::String) add_text(texts, value->names[i], item.string);
  }
  return texts;
}

const JsonValue* either(const JsonValue& object, std::string_view a, std::string_view b) {
  if (object.kind != Kind::Object) return nullptr;
  const JsonValue* found = find_member(object, a);
  return found != nullptr ? found : find_member(object, b);
}

std::string string_of(const JsonValue* value) {
  return value != nullptr && value->kind == Kind::String ? value->string : std::string();
}

const JsonValue* first_item(const JsonValue* list) {
  return list != nullptr && list->kind == Kind::Array && !list->items.empty() ? &list->items.front()
                                                                              : nullptr;
}

/// The picture of a body: itself, or the first that is offered of several.
std::string image_of_body(const JsonValue* body) {
  if (body == nullptr) return {};
  if (body->kind == Kind::Array) return image_of_body(first_item(body));
  if (body->kind != Kind::Object) return string_of(body);
  const std::string type = string_of(either(*body, "type", "@type"));
  if (type == "Choice") return image_of_body(find_member(*body, "items"));
  if (type == "oa:Choice") return image_of_body(find_member(*body, "default"));
  if (type == "SpecificResource" || type == "oa:SpecificResource") {
    const JsonValue* source = either(*body, "source", "full");
    return image_of_body(source);
  }
  if (type != "Image" && type != "dctypes:Image" && type != "dcTypes:Image" && !type.empty())
    return {};
  return string_of(either(*body, "id", "@id"));
}

/// The first picture that a canvas is painted with.
std::string image_of_canvas(const JsonValue& canvas) {
  if (const JsonValue* images = either(canvas, "images", "images"))  // version 2
    if (const JsonValue* image = first_item(images))
      return image_of_body(either(*image, "resource", "body"));
  const JsonValue* page = first_item(either(canvas, "items", "content"));
  if (page == nullptr || page->kind != Kind::Object) return {};
  const JsonValue* annotations = either(*page, "items", "resources");
  if (annotations == nullptr || annotations->kind != Kind::Array) return {};
  for (const JsonValue& annotation : annotations->items)
    if (const std::string image = image_of_body(either(annotation, "body", "resource"));
        !image.empty())
      return image;
  return {};
}

const JsonValue* canvases_of(const JsonValue& manifest) {
  if (const JsonValue* items = either(manifest, "items", "items");
      items != nullptr && items->kind == Kind::Array)
    return items;
  const JsonValue* sequence = first_item(either(manifest, "sequences", "sequences"));
  return sequence != nullptr ? either(*sequence, "canvases", "items") : nullptr;
}

bool is_one_of(const Texts& labels, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(labels, [&](const auto& label) {
    return std::ranges::find(words, small_letters(label.second)) != words.end();
  });
}

class Reader {
 public:
  Reader(const std::string& file, std::string_view text) : file_(file), lines_(text) {}

  void read(const JsonValue& root) {
    const std::string type = string_of(either(root, "type", "@type"));
    if (type == "Manifest" || type == "sc:Manifest") return read_manifest(root);
    if (type == "Collection" || type == "sc:Collection") return read_collection(root);
    const auto [line, column] = lines_.at(root.offset);
    throw content::ContentError(
        file_, line, column, "not-iiif",
        type.empty() ? "this is JSON without a \"type\", and no IIIF manifest or collection"
                     : "this is JSON of the type '" + type.substr(0, 60) +
                           "', and no IIIF manifest or collection",
        "save the object's manifest: it has \"type\": \"Manifest\"");
  }

  Collection take() { return std::move(collection_); }

 private:
  [[nodiscard]] std::uint32_t line_of(const JsonValue& value) const {
    return lines_.at(value.offset).line;
  }
  void doubt(const JsonValue& where, std::string message, std::string hint = {}) {
    collection_.doubts.push_back({file_, line_of(where), std::move(message), std::move(hint)});
  }

  void read_manifest(const JsonValue& manifest) {
    CollectionObject object{.id = string_of(either(manifest, "id", "@id")),
                            .title = texts_of(either(manifest, "label", "label")),
                            .text = texts_of(either(manifest, "summary", "description")),
                            .image = {},
                            .subject = {},
                            .period = {},
                            .file = file_,
                            .line = line_of(manifest)};
    if (object.id.empty()) doubt(manifest, "this manifest has no id");
    if (object.title.empty()) doubt(manifest, "this manifest has no label, so its object no title");
    read_canvases(manifest, object);
    read_metadata(either(manifest, "metadata", "metadata"), object);
    if (const std::string date = string_of(either(manifest, "navDate", "navDate"));
        object.period.empty() && !date.empty())
      object.period[undetermined] = date;
    collection_.objects.push_back(std::move(object));
  }

  void read_canvases(const JsonValue& manifest, CollectionObject& object) {
    const JsonValue* canvases = canvases_of(manifest);
    if (canvases == nullptr || canvases->kind != Kind::Array || canvases->items.empty())
      return doubt(manifest, "this manifest has no canvas, so its object no picture");
    for (const JsonValue& canvas : canvases->items) {
      const std::string image = image_of_canvas(canvas);
      if (image.empty())
        doubt(canvas, "nothing is painted on this canvas, and it is left out");
      else if (object.image.empty())
        object.image = image;
    }
  }

  static void read_metadata(const JsonValue* pairs, CollectionObject& object) {
    if (pairs == nullptr || pairs->kind != Kind::Array) return;
    for (const JsonValue& pair : pairs->items) {
      if (pair.kind != Kind::Object) continue;
      const Texts label = texts_of(find_member(pair, "label"));
      const JsonValue* value = find_member(pair, "value");
      if (is_one_of(label, {"subject", "subjects", "keywords", "topic"}))
        for (const auto& [language, text] : texts_of(value)) object.subject.push_back(text);
      if (is_one_of(label, {"date", "created", "date created"}) && object.period.empty())
        object.period = texts_of(value);
    }
  }

  void read_collection(const JsonValue& collection) {
    constexpr std::array<std::string_view, 4> lists{"items", "manifests", "collections", "members"};
    for (const std::string_view name : lists) {
      const JsonValue* list = find_member(collection, name);
      if (list == nullptr || list->kind != Kind::Array) continue;
      for (const JsonValue& member : list->items) read_member(member);
    }
  }

  void read_member(const JsonValue& member) {
    const std::string type = string_of(either(member, "type", "@type"));
    if (canvases_of(member) != nullptr && (type == "Manifest" || type == "sc:Manifest"))
      return read_manifest(member);
    const std::string id =
        member.kind == Kind::String ? member.string : string_of(either(member, "id", "@id"));
    if (id.empty()) return doubt(member, "this member of the collection has no id");
    collection_.members.push_back(id);
  }

  const std::string& file_;
  LineIndex lines_;
  Collection collection_;
};

}  // namespace

Collection read_iiif(const std::string& file, std::string_view text) {
  Reader reader(file, text);
  reader.read(parse_json(file, text));
  return reader.take();
}

}  // namespace docent::import
