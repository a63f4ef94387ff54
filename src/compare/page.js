'use strict';
(() => {
  const frames = [...document.querySelectorAll('article')];
  const links = [...document.querySelectorAll('.frames nav a')];
  if (!frames.length) return;
  document.body.classList.add('js');
  let here = 0;
  let mode = 'side';

  const stageOf = frame => frame.querySelector('.stage');
  const sliderOf = frame => frame.querySelector('input[type=range]');

  // a frame that one side lacks has only its picture to show
  const modesOf = frame => [...frame.querySelectorAll('button')].map(button => button.dataset.mode);

  function draw() {
    frames.forEach((frame, i) => frame.classList.toggle('here', i === here));
    links.forEach((link, i) => link.classList.toggle('here', i === here));
    const frame = frames[here];
    const shown = modesOf(frame).includes(mode) ? mode : 'side';
    stageOf(frame).className = 'stage ' + shown + (shown === 'side' ? '' : ' one');
    frame.querySelectorAll('button').forEach(button => button.classList.toggle('on', button.dataset.mode === shown));
    const slider = sliderOf(frame);
    if (slider) {
      slider.classList.toggle('shown', shown === 'slider');
      stageOf(frame).style.setProperty('--at', slider.value + '%');
    }
  }

  function go(to, note) {
    here = Math.min(Math.max(to, 0), frames.length - 1);
    draw();
    links[here].scrollIntoView({block: 'nearest'});
    if (note) history.replaceState(null, '', '#' + frames[here].id);
  }

  function show(wanted) {
    mode = wanted;
    draw();
  }

  function slide(by) {
    const slider = sliderOf(frames[here]);
    if (!slider) return;
    slider.value = Number(slider.value) + by;
    draw();
  }

  function fromAddress() {
    const found = frames.findIndex(frame => '#' + frame.id === location.hash);
    if (found >= 0) go(found, false);
  }

  frames.forEach(frame => {
    frame.querySelectorAll('button').forEach(button => button.addEventListener('click', event => {
      // after a click with the mouse the space bar is the page's again
      if (event.detail > 0) button.blur();
      show(button.dataset.mode);
    }));
    const slider = sliderOf(frame);
    if (!slider) return;
    slider.addEventListener('input', draw);
    const stage = stageOf(frame);
    stage.addEventListener('pointermove', event => {
      if (!stage.classList.contains('slider') || (event.pointerType !== 'mouse' && !event.isPrimary)) return;
      const box = stage.querySelector('img').getBoundingClientRect();
      slider.value = 100 * (event.clientX - box.left) / box.width;
      draw();
    });
  });
  links.forEach((link, i) => link.addEventListener('click', event => {
    event.preventDefault();
    go(i, true);
  }));
  window.addEventListener('hashchange', fromAddress);

  const keys = {
    ArrowDown: () => go(here + 1, true), j: () => go(here + 1, true),
    ArrowUp: () => go(here - 1, true), k: () => go(here - 1, true),
    Home: () => go(0, true), End: () => go(frames.length - 1, true),
    1: () => show('side'), 2: () => show('slider'), 3: () => show('blink'),
    4: () => show('difference'), 5: () => show('perception'),
    ArrowLeft: () => slide(-2), ArrowRight: () => slide(2),
    ' ': () => { if (mode !== 'blink') show('blink'); stageOf(frames[here]).classList.toggle('turned'); },
  };
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    if (event.key === ' ' && event.target instanceof HTMLButtonElement) return;
    event.preventDefault();
    keys[event.key]();
  });

  go(0, false);
  fromAddress();
})();
