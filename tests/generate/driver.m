% The class for MATLAB and Octave that a test controls: the commands of driver.c, each answered by 0 and the results, or
% by the identifier and the sentence of the error.
1;

function values = numbers(texts)
  values = cellfun(@(text) hex2dec(text), texts);
end

function say(words)
  printf('0%s\n', sprintf(' %d', words));
end

function answer(name, given)
  global the_link subscriptions
  if ~any(strcmp(name, {'connect', 'subscribe', 'next'}))
    values = numbers(given);
  end
  switch name
    case 'connect'
      cellfun(@(one) one.close(), subscriptions);
      subscriptions = {};
      the_link = [];
      the_link = unity_link.Link(given{1}, str2double(given{2}));
      say([]);
    case 'close', the_link.close(); say([]);
    case 'read', say(the_link.read(values(1)));
    case 'write', the_link.write(values(1), values(2)); say([]);
    case 'masked', say(the_link.write_masked(values(1), values(2), values(3)));
    case 'post', the_link.post(values(1), values(2)); say([]);
    case 'fence', the_link.fence(); say([]);
    case 'rblock', say(the_link.read_block(values(1), values(2)));
    case 'wblock', the_link.write_block(values(1), values(2:end)); say([]);
    case 'rqueue', say(the_link.read_queue(values(1), values(2)));
    case 'wqueue', the_link.write_queue(values(1), values(2:end)); say([]);
    case 'rmany', say(the_link.read_many(values));
    case 'wmany', the_link.write_many(values(1:2:end), values(2:2:end)); say([]);
    case 'subscribe'
      options = {};
      if str2double(given{2}) > 0
        options = {'rate_hz', str2double(given{2})};
      end
      subscriptions{hex2dec(given{1}) + 1} = the_link.subscribe(numbers(given(4:end)), options{:});
      say([]);
    case 'next'
      data = subscriptions{hex2dec(given{1}) + 1}.take(1, str2double(given{2}));
      if isempty(data.sequence)
        printf('39 no sample came in time\n');
      else
        say([data.sequence, data.lost, 0, data.words]);
      end
    case 'publish', subscriptions{values(1) + 1}.publish(); say([]);
    case 'unsubscribe', subscriptions{values(1) + 1}.close(); say([]);
  end
end

global the_link subscriptions
the_link = [];
subscriptions = {};
while true
  try
    line = input('', 's');      % `fgetl` would wait for the text after the line
  catch
    exit(0);
  end
  words = strsplit(strtrim(line), ' ');
  try
    answer(words{1}, words(2:end));
  catch reason
    printf('%s %s\n', reason.identifier, reason.message);
  end
  fflush(stdout);
end
