#include "cli/output/json_output.hpp"

#include "cli/output/streams.hpp"

namespace mmverify::cli {

JsonOutput::JsonOutput(const std::string& path) : on_stdout_(path == "-") {
  if (!path.empty() && !on_stdout_) file_.emplace(path);
}

void JsonOutput::remove_old() const {
  if (file_) file_->remove_old();
}

void JsonOutput::write(const std::function<std::string()>& json) {
  if (file_) file_->commit(json());
  if (on_stdout_) say(stdout, "{}", json());
}

}  // namespace mmverify::cli
