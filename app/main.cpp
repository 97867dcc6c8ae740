#include <algorithm>
#include <string_view>
#include <vector>

#include "app/batch/verb.h"
#include "ui/batch/render_verb.h"

int main(int argumentCount, char** arguments) {
  std::vector<stretch::app::Verb> verbs = stretch::app::batchVerbs();
  verbs.push_back(stretch::ui::renderVerb());
  return stretch::app::runVerbs(verbs, argumentCount, arguments);
}
