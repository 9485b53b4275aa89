#pragma once

#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace somato::test {

/// An element of a small XML reader, written from the standard: only what pictures use.
struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  ///< Its own, entities resolved.
  std::vector<Element> children;

  std::string operator[](std::string_view attribute) const {
    for (const auto& [name_of, value] : attributes) {
      if (name_of == attribute) return value;
    }
    return {};
  }
};

/// Reads one document; nothing when it is not well formed.
class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  std::optional<Element> document() {
    Element root;
    if (!element(root)) return std::nullopt;
    skip_space();
    return at_ == text_.size() ? std::optional(root) : std::nullopt;
  }

 private:
  bool take(std::string_view token) {
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    return true;
  }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  std::string name() {
    const std::size_t start = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-')) {
      ++at_;
    }
    return std::string(text_.substr(start, at_ - start));
  }
  // Characters up to `end`; false for a bare & or <, or a control character.
  bool characters(char end, std::string& out) {
    while (at_ < text_.size() && text_[at_] != end) {
      const auto byte = static_cast<unsigned char>(text_[at_]);
      if (byte == '<' || (byte < 0x20 && byte != '\n')) return false;
      if (byte == '&') {
        if (!entity(out)) return false;
      } else {
        out += text_[at_++];
      }
    }
    return at_ < text_.size();
  }
  bool entity(std::string& out) {
    constexpr std::pair<std::string_view, char> kEntities[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
    for (const auto& [token, character] : kEntities) {
      if (!take(token)) continue;
      out += character;
      return true;
    }
    return false;
  }
  bool attribute(Element& element) {
    std::pair<std::string, std::string> read;
    read.first = name();
    if (read.first.empty() || !element[read.first].empty()) return false;
    if (!take("=\"") || !characters('"', read.second) || !take("\"")) return false;
    element.attributes.push_back(read);
    return true;
  }
  bool element(Element& element) {
    if (!take("<")) return false;
    element.name = name();
    if (element.name.empty()) return false;
    while (take(" ")) {
      if (!attribute(element)) return false;
    }
    return take("/>") || (take(">") && content(element));
  }
  bool content(Element& element) {
    while (true) {
      if (!characters('<', element.text)) return false;
      if (take("</")) return name() == element.name && take(">");
      element.children.emplace_back();
      if (!this->element(element.children.back())) return false;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

inline std::optional<Element> read_xml(std::string_view text) {
  return XmlReader(text).document();
}

/// All elements within `root` for which `matches` holds, in the order of the document.
template <typename Matches>
std::vector<Element> find(const Element& root, const Matches& matches) {
  std::vector<Element> found;
  if (matches(root)) found.push_back(root);
  for (const Element& child : root.children) {
    for (Element& within : find(child, matches)) found.push_back(std::move(within));
  }
  return found;
}

/// The groups of a class.
inline std::vector<Element> groups(const Element& root, std::string_view class_name) {
  return find(root, [&](const Element& e) { return e.name == "g" && e["class"] == class_name; });
}

inline std::vector<Element> elements(const Element& root, std::string_view name) {
  return find(root, [&](const Element& e) { return e.name == name; });
}

}  // namespace somato::test
