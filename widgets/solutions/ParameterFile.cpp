// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterFile.h"

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/session/Session.h"
#include "widgets/solutions/ParameterModel.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

Result<std::filesystem::path> parameterFileHere(const robotlink::Session& session, const std::string& robot,
                                                const robotcontrol::ParameterValues& values) {
  const auto remote = session.remoteRobots().find(robot);
  if (remote != session.remoteRobots().end())
    return failure("parameters.elsewhere",
                   "the program of " + robot + " runs at " + remote->second.url + ", and so does its file " +
                       values.file() + "; save the parameters to a file here, and deploy it to the robot",
                   {}, {robot, values.file()});
  if (values.file().empty())
    return failure("parameters.no-file",
                   "the program of " + robot +
                       " does not say where its parameters are from; save them to "
                       "another file",
                   {}, {robot});
  return std::filesystem::path(values.file());
}

Result<void> saveParameters(const ParameterModel& model, const std::filesystem::path& file) {
  std::optional<std::string> text;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    auto read = robotlink::readFile(file);
    if (!read) return tl::unexpected(read.error());
    text = std::move(*read);
  }
  const auto edited = model.inFile(text, file.string());
  if (!edited) return tl::unexpected(edited.error().front());
  auto written = robotlink::writeFileAtomically(file, *edited);
  if (!written) written.error().text += "; save the parameters to another file";
  return written;
}

robotcontrol::Request savedParameters(const ParameterModel& model, const robotcontrol::ParameterValues& of) {
  robotcontrol::Request request;
  auto& set = *request.mutable_set_parameters();
  set.set_task(of.task());
  set.set_solution(of.solution());
  set.mutable_value()->set_type(model.typeName());
  set.mutable_value()->set_data(model.value().toStdString());
  set.set_saved(true);
  return request;
}

}  // namespace widgets
