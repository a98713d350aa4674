// The part of pugixml with which the program writes XML.  Debian has its header, but not its source, so there
// is no pugixml for WebAssembly; tests/wasm compares the written bytes with the real one's.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <list>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace pugi {

namespace written {

struct Node {
  std::string name, text;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::list<Node> children;  // a list, so that addresses stay
};

inline std::string escaped(const std::string& text, bool attribute) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += attribute ? "&quot;" : "\""; break;
      default:
        if (static_cast<unsigned char>(c) < 32 && (attribute || (c != '\n' && c != '\t' && c != '\r'))) {
          char number[8];
          std::snprintf(number, sizeof number, "&#%02d;", c);
          out += number;
        } else {
          out += c;
        }
    }
  return out;
}

inline void write(std::ostream& out, const Node& node, const std::string& indent, const std::string& before) {
  out << before << '<' << node.name;
  for (const auto& [name, value] : node.attributes)
    out << ' ' << name << "=\"" << escaped(value, true) << '"';
  if (node.children.empty() && node.text.empty()) {
    out << " />\n";
  } else if (node.children.empty()) {
    out << '>' << escaped(node.text, false) << "</" << node.name << ">\n";
  } else {
    out << ">\n";
    for (const Node& child : node.children) write(out, child, indent, before + indent);
    out << before << "</" << node.name << ">\n";
  }
}

}  // namespace written

class xml_attribute {
 public:
  explicit xml_attribute(std::string& value) : value_(&value) {}
  const char* value() const { return value_->c_str(); }
  xml_attribute& operator=(const char* text) { return *value_ = text, *this; }
  xml_attribute& operator=(int number) { return *value_ = std::to_string(number), *this; }
  xml_attribute& operator=(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return *value_ = text, *this;
  }

 private:
  std::string* value_;
};

class xml_text {
 public:
  explicit xml_text(std::string& text) : text_(&text) {}
  xml_text& operator=(const char* text) { return *text_ = text, *this; }

 private:
  std::string* text_;
};

class xml_node {
 public:
  xml_node() = default;
  explicit xml_node(written::Node& node) : node_(&node) {}
  xml_node append_child(const char* name) {
    written::Node& child = node_->children.emplace_back();
    child.name = name;
    return xml_node(child);
  }
  xml_attribute append_attribute(const char* name) {
    return xml_attribute(node_->attributes.emplace_back(name, "").second);
  }
  /// The attribute of a name.  Domain: an attribute that was appended.
  xml_attribute attribute(const std::string& name) const {
    for (auto& [key, value] : node_->attributes)
      if (key == name) return xml_attribute(value);
    std::abort();
  }
  xml_text text() { return xml_text(node_->text); }
  explicit operator bool() const { return node_ != nullptr; }

 protected:
  written::Node* node_ = nullptr;
};

class xml_document : public xml_node {
 public:
  xml_document() { node_ = &root_; }
  xml_document(const xml_document&) = delete;
  xml_document& operator=(const xml_document&) = delete;

  void save(std::ostream& out, const char* indent = "\t") const {
    out << "<?xml version=\"1.0\"?>\n";
    for (const written::Node& child : root_.children) written::write(out, child, indent, "");
  }

 private:
  written::Node root_;
};

}  // namespace pugi
