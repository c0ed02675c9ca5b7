import { element } from '../dom';

/**
 * Views with their controls, and the plots: side by side where there is room for both. The views
 * then stay in sight while the plots are scrolled; what is higher than the window stays with its
 * lower end. Without a view the plots have the whole width.
 */
export function beside(views: HTMLElement, controls: HTMLElement, plots: HTMLElement): HTMLElement {
  const stage = element('div', { class: 'stage' }, views, controls);
  const kind = views.querySelector('.view') ? 'beside' : 'beside alone';
  new ResizeObserver(() => {
    stage.style.setProperty('--height', `${stage.offsetHeight}px`);
  }).observe(stage);
  return element('div', { class: kind }, stage, plots);
}
