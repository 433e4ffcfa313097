// widgets/plots/SvgEngine.h - turns painting into SVG elements.
#pragma once

#include <QMap>
#include <QPaintEngine>
#include <QPainterPath>
#include <QString>

namespace squat::plots {

class SvgEngine : public QPaintEngine {
 public:
  SvgEngine();

  bool begin(QPaintDevice* device) override;
  bool end() override { return true; }
  Type type() const override { return QPaintEngine::User; }
  void updateState(const QPaintEngineState& state) override;
  using QPaintEngine::drawPolygon;
  void drawPath(const QPainterPath& path) override;
  void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override;
  void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override;
  void drawImage(const QRectF& target, const QImage& image, const QRectF& source,
                 Qt::ImageConversionFlags flags) override;
  void drawTextItem(const QPointF& position, const QTextItem& item) override;

  const QString& definitions() const { return definitions_; }
  const QString& body() const { return body_; }

 private:
  void element(const QString& text);  // within the clip and the transform of now
  QString stroke() const;
  QString fill() const;

  QString definitions_, body_;
  QMap<QString, QString> clips_;  // rectangle as text -> its name
};

}  // namespace squat::plots
