#include "runtime/guide/captions.h"

#include <utility>

namespace docent::guide {

void Captions::step(const Session& session, const interface::ScreenShape& shape,
                    plan::Planner& planner, float seconds) noexcept {
  const Voice& voice = session.voice();
  overlay_.advance(seconds);
  is_said_ = voice.now().kind != interface::SpeechPart::Kind::Nothing;
  left_ = voice.share_left();
  const Saying* begun = voice.saying();
  if (begun == nullptr || begun->utterance == nullptr || planner.parts() <= part) return;
  is_answered_ = false;
  interface::ViewRequest request{++last_request_, session.view()->state, shape,
                                 session.route_summary(), part};
  request.said = voice.now();
  planner.ask(request);
}

void Captions::take(std::unique_ptr<interface::View> view) noexcept {
  if (view->request != last_request_) return;
  is_answered_ = true;
  overlay_.enter(std::move(view));
}

void Captions::draw(scene::DrawList& list) const noexcept {
  if (is_shown()) overlay_.draw(left_, 0, {}, list);
}

}  // namespace docent::guide
